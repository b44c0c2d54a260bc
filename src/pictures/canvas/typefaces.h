#pragma once

// The typefaces of the window and of pictures: Inter or, without it, another installed one; and
// what the system has for other scripts.

#include <filesystem>
#include <vector>

namespace cambrian {

enum class Typeface : unsigned char { kRegular, kStrong, kMono };

// Returns the installed font files of a typeface, best first; may be empty.
std::vector<std::filesystem::path> installed_files(Typeface typeface);

struct FontFile {
    std::filesystem::path path;
    int face = 0;  // index in a file of several
};
// A font file and the letters to take from it, as code points.
struct LettersOfFile {
    FontFile file;
    std::vector<int> letters;
};
// Returns the system's font files, of those like the typeface, that have these letters. Letters
// that none has are left out. May be called on any thread, and takes seconds where fonts were just
// installed.
std::vector<LettersOfFile> files_with(const std::vector<int>& letters, Typeface typeface);

}  // namespace cambrian
