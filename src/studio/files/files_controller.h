#pragma once

// Owns files and samples: the file browser, reading and writing, and the effects of a file on the
// other subjects.

#include "studio/experiment/generations_controller.h"
#include "studio/files/file_desk.h"
#include "studio/files/files_contract.h"
#include "studio/hand_picking/picking_controller.h"

#include <filesystem>
#include <optional>

namespace cambrian {

// The controllers that a file may concern; all must outlive what uses them.
struct FileSubjects {
    ViewerController& viewer;
    ExperimentController& experiment;
    GenerationsController& generations;
    PickingController& picking;
};

// Pictures that only the window can draw.
struct PictureOrders {
    std::optional<SaveScreenshot> screenshot;
    std::optional<SavePlotPicture> plot;
    std::optional<PreparedCard> card;
};

class FilesController {
public:
    // Everything that `services` names and `view` must outlive it.
    FilesController(const Services& services, ViewState& view, const FileSubjects& subjects);

    // Once a frame: handles the results of reading and writing.
    void update();
    void carry_out(const FilesRequest& request);
    FilesView facts() const { return {.browser = browser_, .samples = &samples_}; }

    // Samples come from this folder.
    void use_samples(const std::filesystem::path& folder) { samples_folder_ = folder; }
    // Reads a file at once, before the first frame.
    void open_now(const std::filesystem::path& path, ExhibitSource source);
    // Reads, in the background, the experiment that was open when the program was last used.
    void reopen(const std::filesystem::path& path);
    // Whether that is still being read.
    bool reopening() const { return reopening_; }

    // The picture that the window must draw; returned once.
    PictureOrders take_orders() { return std::exchange(orders_, {}); }
    void save_card(const PreparedCard& card, Image picture);
    void save_picture(const std::filesystem::path& path, Image image);

private:
    struct Handler;
    struct Receiver;
    bool may_open(FileTask task);
    std::string suggested_name(FileTask task) const;
    void show(const CreatureDocument& document, ExhibitSource source,
              const std::filesystem::path& path);
    CreatureDocument displayed_document() const;

    Services services_;
    ViewState& view_;
    FileSubjects subjects_;
    FileDesk desk_;
    FileBrowser browser_;
    std::filesystem::path samples_folder_;
    SampleShelf samples_;
    PictureOrders orders_;
    bool reopening_ = false;
};

}  // namespace cambrian
