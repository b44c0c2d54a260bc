#pragma once

// The preserve that is edited by fuzzing: small, with rows in every table.

#include <filesystem>
#include <string>

namespace cambrian::test {

// Returns the bytes of its file, which has many small pages. The file is made in `folder`.
std::string sample_preserve(const std::filesystem::path& folder);

}  // namespace cambrian::test
