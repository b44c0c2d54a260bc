#pragma once

// Letters beyond those that the fonts have from the start. Names of creatures and files may be in
// any script: a letter that is drawn for the first time is looked for in the system's typefaces, on
// another thread, and is there a moment later.

#include "pictures/canvas/typefaces.h"
#include "studio/look/theme.h"

#include <imgui.h>

#include <future>
#include <list>
#include <set>
#include <string_view>
#include <vector>

namespace cambrian {

class ForeignLetters {
public:
    // Must be told of each text that may have other letters when it is drawn. `font` has the
    // letters there are.
    void note(std::string_view text, const ImFont& font);
    // Adds the letters found to the fonts. May be called only between frames. Returns whether the
    // fonts' texture must be made again.
    bool load(const Fonts& fonts);

private:
    struct Found {
        std::vector<LettersOfFile> regular;
        std::vector<LettersOfFile> strong;
    };
    void add(const std::vector<LettersOfFile>& files, ImFont* font);

    std::set<int> asked_;  // all letters that were looked for, found or not
    std::vector<int> wanted_;
    std::future<Found> search_;
    std::list<std::vector<ImWchar>> ranges_;  // which the fonts refer to
};

}  // namespace cambrian
