#pragma once

#include "app/command_files.h"
#include "core/result.h"

#include <filesystem>
#include <string>

namespace cambrian {

// Where a result goes: `asked` itself, or `name` inside it if it is a folder (one that exists, or
// that ends in '/' and is then made). Fails at once if no file can be written there, so that
// nobody computes for hours and then loses the result.
// `files`: of the same command, none of which is to be written onto.
Result<std::filesystem::path> output_path(const std::string& asked, const std::string& name,
                                          const CommandFiles& files);

}  // namespace cambrian
