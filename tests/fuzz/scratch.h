#pragma once

// Files that a target writes again and again.

#include "fuzz/byte_source.h"

#include <filesystem>
#include <string>

namespace cambrian::test {

// Returns a folder in memory if there is one.
std::filesystem::path scratch_folder();

// Returns the database file with bytes or pages replaced. Its pages must have 512 bytes.
std::string with_patched_pages(std::string file, ByteSource bytes);

}  // namespace cambrian::test
