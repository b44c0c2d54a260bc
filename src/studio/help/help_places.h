#pragma once

#include "studio/help/help_index.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cambrian {

// A place of the help that can be found by its text.
struct HelpPlace {
    std::string page;       // name
    std::string title;      // of the page
    std::string heading;    // the last one above it; that of the page is its title
    std::size_t block = 0;  // of the page
    std::string text;       // without marks
};

// Returns the places of all pages in their order. Pictures are none.
std::vector<HelpPlace> help_places(const HelpIndex& index);

}  // namespace cambrian
