#pragma once

// The pages of the help: those written into the program and the files of the help folder.

#include "studio/widgets/markdown.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr const char* kFirstStepsPage = "first-steps";
inline constexpr const char* kKeysPage = "keys";
inline constexpr const char* kAboutPage = "about";

struct HelpPage {
    std::string name;   // "experiment", as files and links name it
    std::string title;  // its first heading
    std::vector<MarkdownBlock> blocks;
};

// From a page's text; without a heading the name is its title.
HelpPage help_page(const std::string& name, std::string_view text);

struct HelpBook {
    std::vector<HelpPage> pages;  // in the order listed
    std::string open = kFirstStepsPage;
};

// First steps, keys, the folder's pages by title, and what the program is made of. `keys` is the
// text of the page of keys. Files that cannot be read are left out.
std::vector<HelpPage> read_help(const std::filesystem::path& folder, std::string_view keys);

}  // namespace cambrian
