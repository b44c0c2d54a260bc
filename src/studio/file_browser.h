#pragma once

// What the file panel shows: a folder's sub-folders and the files the studio can open. Filled by
// the background worker.

#include "studio/requests.h"

#include <filesystem>
#include <string>
#include <vector>

namespace cambrian {

struct FolderListing {
    std::filesystem::path folder;
    std::vector<std::string> folders;  // by name
    std::vector<std::string> files;    // by name
    std::string problem;               // why it could not be read, or empty
};

struct FileBrowser {
    bool open = false;
    FileTask task = FileTask::kOpen;
    FolderListing listing;
    std::string suggested_name;
    unsigned opened = 0;  // counts openings, so that the panel resets what was typed
};

// Reads a folder; hidden entries are left out.
FolderListing list_folder(const std::filesystem::path& folder, FileTask task);

}  // namespace cambrian
