#pragma once

// What the file panel shows: a folder's sub-folders and the files the studio can open. Filled by
// the background worker.

#include <filesystem>
#include <string>
#include <vector>

namespace cambrian {

enum class FileTask : std::uint8_t {
    kOpen,
    kSaveCreature,
    kSaveExperiment,
    kSaveSettings,
    kSaveStatistics,
    kSavePlot
};
// In pixels.
struct PictureSize {
    int width = 1280;
    int height = 720;
};

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
    PictureSize picture;  // of a plot to be saved
    unsigned opened = 0;  // counts openings, so that the panel resets what was typed
};

// How the names of files written for a task end; of kOpen, how those of creatures do.
const char* ending_of(FileTask task);

// Reads a folder; hidden entries are left out.
FolderListing list_folder(const std::filesystem::path& folder, FileTask task);

}  // namespace cambrian
