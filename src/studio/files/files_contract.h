#pragma once

// The data of files and samples that panels see, and the requests they may make of them.

#include "studio/files/clip_maker.h"
#include "studio/files/file_browser.h"
#include "studio/files/long_files.h"
#include "studio/files/recent_runs.h"
#include "studio/files/sample_library.h"

#include <cstddef>
#include <filesystem>
#include <variant>

namespace cambrian {

struct OpenFilePanel {
    FileTask task = FileTask::kOpen;
    PictureSize picture = {};  // size of the plot's picture
};
struct CloseFilePanel {};
struct ListFolder {
    std::filesystem::path folder;
};
struct LoadFile {
    std::filesystem::path path;
};
struct SaveCreatureFile {
    std::filesystem::path path;
};
// Displays a creature of the picking grid and opens the file panel to save it.
struct SaveCell {
    std::size_t cell = 0;
};
// Displays the creature picked in the preserve and opens the file panel to save it.
struct SaveResident {};
// Does so with the creature that was chosen in the preserve's museum.
struct SavePiece {};
// Keeps the preserve in another file from now on.
struct SavePreserveFile {
    std::filesystem::path path;
};
struct SaveExperimentFile {
    std::filesystem::path path;
};
struct OpenPreviousRun {};
struct SaveSettingsFile {
    std::filesystem::path path;
};
struct SaveStatisticsFile {
    std::filesystem::path path;
};
struct SavePlotPicture {
    std::filesystem::path path;
    PictureSize size;
};
struct SaveScreenshot {
    std::filesystem::path path;  // empty for a new name in the user's folder of pictures
};
// Saves a clip of the creature on display.
struct SaveClip {
    std::filesystem::path path;
    ClipChoice choice;
};
// Saves what was seen in the last seconds, under a new name in the user's folder of pictures.
struct SaveSeen {};
// Saves a page of the present run's champions.
struct SaveRunPage {
    std::filesystem::path path;
};
// Saves a film of the present run's champions; the choice's seconds are those of each.
struct SaveFilm {
    std::filesystem::path path;
    ClipChoice choice;
};
// Saves a race of the starred creatures.
struct SaveRace {
    std::filesystem::path path;
    ClipChoice choice;
};
// Gives up the clip or page that is being written.
struct StopFile {};
// Puts the picture of the viewport on the clipboard.
struct CopyPicture {};
struct ToggleSamples {};
// Lets a sample move on its tile; an empty path ends that.
struct WatchSample {
    std::filesystem::path path;
};
struct ToggleStartPage {};
// Opens a run of the start page.
struct OpenRun {
    std::filesystem::path path;
};
// Takes a run off the start page; its file stays.
struct ForgetRun {
    std::filesystem::path path;
};
// Leaves for the world of other dimensions and begins a run there.
struct BeginElsewhere {};

using FilesRequest =
    std::variant<OpenFilePanel, CloseFilePanel, ListFolder, LoadFile, SaveCreatureFile, SaveCell,
                 SaveResident, SavePiece, SavePreserveFile, SaveExperimentFile, OpenPreviousRun,
                 SaveSettingsFile, SaveStatisticsFile, SavePlotPicture, SaveScreenshot, SaveClip,
                 SaveSeen, SaveRunPage, SaveFilm, SaveRace, StopFile, CopyPicture, ToggleSamples,
                 WatchSample, ToggleStartPage, OpenRun, ForgetRun, BeginElsewhere>;

struct FilesView {
    const FileBrowser& browser;
    const SampleLibrary* samples = nullptr;
    const StartPage* start = nullptr;
    FileProgress writing = {};  // of a clip or page; without a name if none is being written
};

}  // namespace cambrian
