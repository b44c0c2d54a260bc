#include "studio/files/file_browser.h"

#include "persist/creature/creature_card.h"
#include "persist/creature/page_document.h"
#include "studio/files/clip_maker.h"

#include <fmt/core.h>

#include <algorithm>
#include <string_view>
#include <system_error>

namespace cambrian {
namespace {

bool suits(std::string_view name, FileTask task) {
    if (name.ends_with(ending_of(task))) return true;
    if (task == FileTask::kSaveCreature)
        return name.ends_with(kCardEnding) || name.ends_with(kPageEnding);
    if (is_of_clips(task)) return is_clip_name(name);
    // Cards may have lost the first part of their double ending when they were sent.
    return task == FileTask::kOpen &&
           (name.ends_with(".toml") || name.ends_with(".png") || name.ends_with(".apng") ||
            name.ends_with(kPageEnding) || name.ends_with(ending_of(FileTask::kSaveExperiment)));
}

}  // namespace

std::string_view ending_of(FileTask task) {
    switch (task) {
        case FileTask::kOpen:
        case FileTask::kSaveCreature:
            break;
        case FileTask::kSaveClip:
        case FileTask::kSaveFilm:
        case FileTask::kSaveRace:
            return ".gif";
        case FileTask::kSaveExperiment:
        case FileTask::kSavePreserve:
            return ".cambrian";
        case FileTask::kSaveSettings:
            return ".toml";
        case FileTask::kSaveStatistics:
            return ".csv";
        case FileTask::kSavePlot:
            return ".png";
        case FileTask::kSaveRunPage:
            return kPageEnding;
    }
    return kCreatureEnding;
}

std::string free_name(const std::filesystem::path& folder, const std::string& name,
                      std::string_view ending) {
    if (!name.ends_with(ending)) return name;
    const std::string stem = name.substr(0, name.size() - ending.size());
    std::string free = name;
    std::error_code unknown;
    for (int number = 2; std::filesystem::exists(folder / free, unknown); ++number)
        free = fmt::format("{}-{}{}", stem, number, ending);
    return free;
}

FolderListing list_folder(const std::filesystem::path& folder, FileTask task) {
    namespace fs = std::filesystem;
    FolderListing listing;
    std::error_code error;
    listing.folder = fs::weakly_canonical(folder, error);
    if (error) listing.folder = folder;
    auto entry = fs::directory_iterator(listing.folder, error);
    if (error) {
        listing.problem = "The folder cannot be read: " + error.message();
        return listing;
    }
    for (const auto end = fs::directory_iterator(); entry != end; entry.increment(error)) {
        if (error) break;
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.')) continue;
        std::error_code unknown;
        if (entry->is_directory(unknown)) {
            listing.folders.push_back(name);
        } else if (suits(name, task)) {
            listing.files.push_back(name);
        }
    }
    std::sort(listing.folders.begin(), listing.folders.end());
    std::sort(listing.files.begin(), listing.files.end());
    return listing;
}

}  // namespace cambrian
