#pragma once

// Selection by hand without threads: commands change its state, work() makes the requested grids.
// The same sequence of commands and work gives the same grids with every back-end. A grid depends
// only on picks, settings and its number, not on grids bred in advance and discarded.

#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/kinds/evolution_kinds.h"
#include "picking/assistance.h"
#include "picking/grid/grid_making.h"
#include "picking/picking_command.h"
#include "picking/picking_snapshot.h"

#include <optional>
#include <stop_token>
#include <string>

namespace cambrian {

// Most of its functions carry out one kind of command each.
class PickingSession {
public:
    // The settings must pass check_settings(); `kinds` must outlive the object. There is no grid at
    // first.
    PickingSession(SettingsPtr settings, const EvolutionKinds& kinds);

    void apply(PickingCommand command);

    // Whether there is a grid to make, for a decision or in advance.
    bool has_work() const;
    // Continues making it, at most to the end of a generation. Returns false if stopped.
    bool work(EvaluationBackend& backend, EvaluationProgress& progress,
              const std::stop_token& stop);
    // Cancels the grid that is being made and reports the reason.
    void fail(std::string message);

    const PickingSnapshot& snapshot() const { return shown_; }

private:
    // A grid that is being made.
    struct Work {
        GridNode draft;  // the grid for the tree, without its creatures
        GridOrder order;
        // Evolution that runs first and fills the order's pool.
        std::optional<Assistance> assistance;
        std::optional<GridMaking> making;
    };

    Status carry_out(ShowPopulation& command);
    Status carry_out(StartFromCreatures& command);
    Status carry_out(RestoreGrids& command);
    Status carry_out(UseSettings& command);
    Status carry_out(const ChangeGrid& command);
    Status carry_out(const TogglePick& command);
    Status carry_out(const ClearPicks& command);
    Status carry_out(const BreedPicks& command);
    Status carry_out(const ReplaceUnpicked& command);
    Status carry_out(const AskEvolution& command);
    Status carry_out(const CancelDecision& command);
    Status carry_out(const GoBack& command);
    Status carry_out(const GoForward& command);
    Status carry_out(const VisitGrid& command);
    Status carry_out(const PinCreature& command);
    Status carry_out(const UnpinCreature& command);
    Status carry_out(const PlacePinned& command);

    bool deciding() const { return shown_.status != PickingStatus::kOpen; }
    Status check_open() const;
    Status check_cell(std::uint32_t node, std::size_t cell) const;
    std::uint32_t next_number() const;
    std::vector<IndividualPtr> parents() const;
    GridNode draft_of(GridOrigin origin) const;
    GridOrder order_of(std::vector<IndividualPtr> parents) const;
    void begin(GridNode draft, GridOrder order);
    void decide();
    void finish_decision();
    void breed_ahead();
    void stop_work();
    void show_grid(GridNode node);
    void recall_picks();

    const EvolutionKinds& kinds_;
    PickingSnapshot shown_;
    std::optional<Work> work_;
};

}  // namespace cambrian
