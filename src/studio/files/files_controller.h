#pragma once

// Owns files and samples: the file browser, reading and writing, and the effect of a loaded file on
// the other controllers.

#include "persist/page/page_file.h"
#include "pictures/clips/seen_clip.h"
#include "studio/experiment/generations_controller.h"
#include "studio/files/file_service.h"
#include "studio/files/files_contract.h"
#include "studio/files/long_files.h"
#include "studio/hand_picking/picking_controller.h"
#include "studio/preserve/preserve_controller.h"

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace cambrian {

// The controllers that loading a file may affect. All must outlive the files controller.
struct FileSubjects {
    ViewerController& viewer;
    ExperimentController& experiment;
    GenerationsController& generations;
    PickingController& picking;
    PreserveController& preserve;
};

// Requests for pictures that only the window can draw.
struct PictureOrders {
    std::optional<SaveScreenshot> screenshot;
    std::optional<SavePlotPicture> plot;
    std::optional<PreparedCard> card;
    bool seen = false;  // the clip of the last seconds
    bool copy = false;  // the picture of the viewport, for the clipboard
};

// A way from a world into the one of other dimensions.
struct SpaceCrossing {
    std::filesystem::path file;  // to open there; empty to begin a run
};

class FilesController {
public:
    // The references in `services`, and `view`, must outlive the controller.
    FilesController(const Services& services, ViewState& view, const FileSubjects& subjects);

    // Must be called once a frame, `elapsed` seconds after the last one; handles finished reads and
    // writes.
    void update(double elapsed);
    // Whether a sample moves.
    bool animating() const { return samples_.motion != nullptr; }
    void carry_out(const FilesRequest& request);
    FilesView facts() const {
        return {.browser = browser_,
                .samples = &samples_,
                .start = &start_,
                .writing = long_files_.progress()};
    }
    unsigned saves() const { return saves_; }  // number of files saved so far

    // Sets the folders of the sample creatures.
    void use_samples(std::vector<std::filesystem::path> folders) {
        sample_folders_ = std::move(folders);
    }
    // Its creatures are shown below the samples.
    void use_museum(const std::filesystem::path& folder) { museum_ = folder; }
    void use_challenges(const std::filesystem::path& folder) { challenges_folder_ = folder; }
    // Sets what pages are made of.
    void use_page_parts(PageParts parts) { page_parts_ = std::move(parts); }
    // Reads a file at once, before the first frame.
    void open_now(const std::filesystem::path& path, ExhibitSource source);
    // Reads, in the background, the experiment that was open when the program was last used.
    void reopen(const std::filesystem::path& path);
    // The runs that were used lately, the last one first.
    void use_recent(std::vector<std::filesystem::path> paths) { start_.paths = std::move(paths); }
    const std::vector<std::filesystem::path>& recent() const { return start_.paths; }
    // Returns where the user wants to go, once it is another world than this one.
    const std::optional<SpaceCrossing>& crossing() const { return crossing_; }
    // Whether reopen() is still reading.
    bool reopening() const { return reopening_; }

    // Returns the pictures that the window must draw, once.
    PictureOrders take_orders() { return std::exchange(orders_, {}); }
    void save_card(const PreparedCard& card, Image picture);
    void save_picture(const std::filesystem::path& path, Image image);
    void save_seen(const std::filesystem::path& path, SeenClip seen);
    const SampleLibrary& samples() const { return samples_; }
    // Reads the samples in the background unless that was done.
    void want_samples();

private:
    struct Handler;
    struct Receiver;
    bool may_open(FileTask task);
    void read_sample_folder();
    void read_runs();
    std::string suggested_name(FileTask task) const;
    void watch_sample(const std::filesystem::path& path);
    void show(const CreatureDocument& document, ExhibitSource source,
              const std::filesystem::path& path);
    CreatureDocument displayed_document() const;
    void write_page(const std::filesystem::path& path);
    void tell_finished_files();

    Services services_;
    ViewState& view_;
    FileSubjects subjects_;
    FileService file_service_;
    LongFiles long_files_;
    PageParts page_parts_;
    FileBrowser browser_;
    std::vector<std::filesystem::path> sample_folders_;
    std::filesystem::path museum_;
    std::filesystem::path challenges_folder_;
    SampleLibrary samples_;
    std::optional<GridMotion> sample_motion_;  // of the sample that is watched
    StartPage start_;
    unsigned saves_ = 0;
    PictureOrders orders_;
    bool reopening_ = false;
    std::optional<SpaceCrossing> crossing_;
};

}  // namespace cambrian
