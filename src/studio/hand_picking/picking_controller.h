#pragma once

// Owns selection by hand: enters and leaves it, and keeps what was picked in the experiment's file.

#include "studio/experiment/experiment_controller.h"
#include "studio/hand_picking/hand_picking.h"
#include "studio/hand_picking/picking_contract.h"

#include <memory>
#include <optional>

namespace cambrian {

class PickingController {
public:
    // Everything that `services` names, `view`, `viewer` and `experiment` must outlive it.
    PickingController(const Services& services, ViewState& view, ViewerController& viewer,
                      ExperimentController& experiment, std::size_t workers);

    // Once a frame: plays the grid on by `elapsed` seconds and keeps what was picked.
    void update(double elapsed);
    void carry_out(const PickingRequest& request);
    // Playback keys act on the grid while it is displayed; false for a request it leaves alone.
    bool take_over(const ViewerRequest& request);
    // Null in automatic evolution.
    const PickingView* facts() const { return facts_ ? &*facts_ : nullptr; }

    bool on() const { return picking_.on(); }
    bool grid_shown() const { return picking_.grid_shown(); }
    // Displays a creature of the grid; false if there is no such cell.
    bool show_cell(std::size_t cell);
    // A creature was loaded from a file: it has the viewport alone.
    void yield_viewport() { picking_.choices().single = picking_.on(); }
    // A creature was saved to a file.
    // The grids of an experiment that was opened.
    void restore(PickingRecord record);

private:
    struct Handler;
    void enter();
    void leave();
    void keep();

    Services services_;
    ViewState& view_;
    ViewerController& viewer_;
    ExperimentController& experiment_;
    HandPicking picking_;
    std::optional<PickingView> facts_;  // of this frame
    std::shared_ptr<const PickingSnapshot> kept_;
};

}  // namespace cambrian
