#pragma once

// The typefaces of the window and of pictures: Inter, or what is installed.

#include <filesystem>
#include <vector>

namespace cambrian {

enum class Typeface : unsigned char { kRegular, kStrong, kMono };

// Files of it that are there, the best first; possibly none.
std::vector<std::filesystem::path> installed_files(Typeface typeface);

}  // namespace cambrian
