#pragma once

// The meaning of a name typed into a field for files.

#include "studio/files/file_browser.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace cambrian {

// Returns the user's folder; empty if none is known.
std::filesystem::path home_folder();
// Replaces a "~" at the beginning of a path, alone or before "/", by the user's folder.
std::filesystem::path with_home(std::string_view path);
// Returns the folder in which the desktop keeps the user's pictures: the one its settings name or
// else "Pictures" in the user's folder. Where there is neither, it is the present folder.
std::filesystem::path pictures_folder();

struct TypedPath {
    std::filesystem::path path = {};
    bool folder = false;     // an existing folder, to be entered
    std::string fault = {};  // why it is no name, in words for the user; empty if it is one
};

// Reads a name or path as typed while the browser shows its folder. A name to save under gets the
// ending of its task.
TypedPath typed_path(const FileBrowser& files, std::string_view typed);

}  // namespace cambrian
