#pragma once

// The content of the file panel: the sub-folders of a folder and the files that the studio can
// open. The background worker fills it.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

enum class FileTask : std::uint8_t {
    kOpen,
    kSaveCreature,
    kSaveClip,
    kSaveExperiment,
    kSavePreserve,
    kSaveSettings,
    kSaveStatistics,
    kSavePlot,
    kSaveRunPage,
    kSaveFilm,
    kSaveRace
};
// A picture's size in pixels.
struct PictureSize {
    int width = 1280;
    int height = 720;
};

struct FolderListing {
    std::filesystem::path folder;
    std::vector<std::string> folders;  // sorted by name
    std::vector<std::string> files;    // sorted by name
    std::string problem;               // why the folder could not be read, or empty
};

struct FileBrowser {
    bool open = false;
    FileTask task = FileTask::kOpen;
    FolderListing listing;
    std::string suggested_name;
    std::filesystem::path own_file;  // the experiment's, which saving it replaces without asking
    PictureSize picture;             // size of the plot's picture to save
    unsigned opened = 0;  // number of openings so far; the panel clears its fields when it changes
};

// Returns whether a task saves moving pictures.
inline bool is_of_clips(FileTask task) {
    return task == FileTask::kSaveClip || task == FileTask::kSaveFilm ||
           task == FileTask::kSaveRace;
}

// Returns the file name ending for a task; for kOpen, that of creature files.
std::string_view ending_of(FileTask task);

// Returns the name or, if the folder has a file of that name, one with a number: "hopper-2.toml".
std::string free_name(const std::filesystem::path& folder, const std::string& name,
                      std::string_view ending);

// Reads a folder. Hidden entries are left out.
FolderListing list_folder(const std::filesystem::path& folder, FileTask task);

}  // namespace cambrian
