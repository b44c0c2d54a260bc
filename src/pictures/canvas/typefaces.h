#pragma once

// The typefaces of the window and of pictures: Inter or, without it, another installed one.

#include <filesystem>
#include <vector>

namespace cambrian {

enum class Typeface : unsigned char { kRegular, kStrong, kMono };

// Returns the installed font files of a typeface, best first; may be empty.
std::vector<std::filesystem::path> installed_files(Typeface typeface);

}  // namespace cambrian
