#pragma once

// Owns selection by hand: enters and leaves the mode, and saves the picks in the experiment's file.

#include "core/threads/thread_share.h"
#include "studio/experiment/experiment_controller.h"
#include "studio/hand_picking/hand_picking.h"
#include "studio/hand_picking/picking_contract.h"

#include <memory>
#include <optional>

namespace cambrian {

class PickingController {
public:
    // The references in `services`, and `view`, `viewer` and `experiment`, must outlive the
    // controller.
    PickingController(const Services& services, ViewState& view, ViewerController& viewer,
                      ExperimentController& experiment, const ThreadShare& threads);

    // Must be called once a frame: plays the grid on by `elapsed` seconds and saves new picks. A
    // new run ends the mode and begins without the grids of the run before.
    void update(double elapsed);
    void carry_out(const PickingRequest& request);
    // Applies a playback request to the grid while it is displayed. Returns false if the request is
    // for the viewer.
    bool take_over(const ViewerRequest& request);
    // Null unless the user selects by hand.
    const PickingView* facts() const { return facts_ ? &*facts_ : nullptr; }

    bool on() const { return picking_.on(); }
    bool grid_shown() const { return picking_.grid_shown(); }
    // Displays one creature of the grid; returns false if there is no such cell.
    bool show_cell(std::size_t cell);
    // Must be called when a creature was loaded from a file, which is then displayed alone.
    void yield_viewport() { picking_.choices().single = picking_.on(); }
    // Restores the grids of an experiment that was opened.
    void restore(PickingRecord record);

private:
    struct Handler;
    void enter();
    void leave(bool resume);  // see ExperimentController::release()
    void keep();

    Services services_;
    ViewState& view_;
    ViewerController& viewer_;
    ExperimentController& experiment_;
    HandPicking picking_;
    std::optional<PickingView> facts_;  // what panels see in this frame
    std::shared_ptr<const PickingSnapshot> kept_;
    unsigned seen_run_ = 0;  // number of runs begun at the last update
};

}  // namespace cambrian
