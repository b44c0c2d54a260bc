#pragma once

// Selection by hand as a mode of the studio. It owns the picking engine, which breeds grids and
// keeps their tree while the program runs, the motion of the displayed grid, and the user's choices
// about it.

#include "core/threads/thread_share.h"
#include "evolution/engine/snapshot.h"
#include "evolution/kinds/evolution_kinds.h"
#include "persist/records/picking_record.h"
#include "picking/picking_engine.h"
#include "studio/background/status_log.h"
#include "studio/hand_picking/picking_view.h"
#include "studio/playback/exhibit.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace cambrian {

class HandPicking {
public:
    // `kinds` must outlive the object. After the first enter(), `threads` evaluate creatures.
    HandPicking(const EvolutionKinds& kinds, const ThreadShare& threads)
        : kinds_(kinds), threads_(threads), motion_(kinds.creature) {}

    // Starts the mode with a grid of the population if that changed since leave(), otherwise with
    // the last grid. Without a population, the first grid has children of the genome `on_show` or,
    // if it is null, random creatures.
    void enter(const EvolutionSnapshot& evolution, const GenomePtr& on_show);
    void leave(const EvolutionSnapshot& evolution);
    // Sets the grids of an experiment that was opened; the next enter() continues with them.
    void restore(PickingRecord record);
    bool on() const { return on_; }
    // Whether the viewport displays the grid rather than one of its creatures.
    bool grid_shown() const { return on_ && !choices_.single; }

    void send(PickingCommand command) { engine_->send(std::move(command)); }
    // Changes the settings with which creatures are evaluated from now on.
    void use(const SettingsPtr& settings);
    // Must be called once a frame: reads the picking engine's latest snapshot, writes its news to
    // the log and plays the motion on by `elapsed` seconds.
    void update(double elapsed, StatusLog& log);

    // Null before the first enter().
    const std::shared_ptr<const PickingSnapshot>& shared_snapshot() const { return snapshot_; }
    std::vector<IndividualPtr> picks() const;
    bool has_cell(std::size_t cell) const;
    // Returns a creature of the displayed grid, with the settings that evaluated it.
    Exhibit exhibit(std::size_t cell) const;
    PickingView view() const;

    // The user's choices about the displayed grid.
    struct Choices {
        PickingOptions options;
        std::size_t focus = 0;  // index of the cell that keys act on
        bool single = false;    // the viewport displays one creature instead of the grid
        bool playing = true;
    };
    Choices& choices() { return choices_; }
    void restart_motion() { motion_.restart(); }

private:
    void follow_grid(StatusLog& log);
    void follow_picks(StatusLog& log);

    const EvolutionKinds& kinds_;
    ThreadShare threads_;
    std::unique_ptr<PickingEngine> engine_;  // null before the first enter()
    std::shared_ptr<const PickingSnapshot> snapshot_;
    SettingsPtr used_;  // the settings sent to the picking engine last
    std::optional<PickingRecord> restored_;
    GridMotion motion_;
    Choices choices_;
    bool on_ = false;
    // The experiment and its number of finished generations at the last leave().
    std::pair<std::uint64_t, std::size_t> left_ = {0, 0};
    std::shared_ptr<const PickingSnapshot> seen_;  // the snapshot at the last update
};

}  // namespace cambrian
