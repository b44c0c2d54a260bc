#pragma once

#include <filesystem>

namespace cambrian {

// Returns in how many dimensions the creature, settings or experiment of a file lives. Where that
// is not to be found, it returns 2, and reading the file will tell what is wrong with it.
int dimensions_of_file(const std::filesystem::path& path);

}  // namespace cambrian
