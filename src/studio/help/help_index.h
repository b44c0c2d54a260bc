#pragma once

// The help pages: those built into the program and the files of the help folder.

#include "studio/widgets/markdown.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr const char* kFirstStepsPage = "first-steps";
inline constexpr const char* kKeysPage = "keys";
inline constexpr const char* kWordsPage = "words";
inline constexpr const char* kAboutPage = "about";

struct HelpPage {
    std::string name;   // "experiment", the name that files and links use
    std::string title;  // its first heading
    std::vector<MarkdownBlock> blocks;
};

// Parses a page's text. Its title is the first heading or, without one, the name. Its pictures are
// not read.
HelpPage help_page(const std::string& name, std::string_view text);

// A picture of a page.
struct HelpPicture {
    std::string page;    // name
    std::string target;  // file
    std::shared_ptr<const Image> image;
};

struct HelpIndex {
    std::vector<HelpPage> pages;  // in the order in which they are listed
    std::string open = kFirstStepsPage;

    // Returns the page that is open; null if there is none of that name.
    const HelpPage* open_page() const;
};

// Returns the page of first steps, the page of keys, the folder's pages by title, and the page on
// the program's components. `keys` and `words` are the texts of the pages of keys and of the words
// for settings. Files that cannot be read are left out.
std::vector<HelpPage> read_help(const std::filesystem::path& folder, std::string_view keys,
                                std::string_view words);

// Returns the pictures that a page has not yet and that can be read: PNG files of the folder.
std::vector<HelpPicture> read_pictures(const std::filesystem::path& folder, const HelpPage& page);
// Gives pictures to the blocks of their pages.
void add_pictures(HelpIndex& index, const std::vector<HelpPicture>& pictures);

}  // namespace cambrian
