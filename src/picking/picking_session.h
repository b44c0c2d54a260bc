#pragma once

// Selection by hand without threads: commands change it, work() makes the grids they ask for. The
// same commands with the same work between them give the same grids, whoever evaluates; and grids
// depend only on picks, settings and their number, not on what was bred ahead in vain.

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

class PickingSession {
public:
    // Settings must pass check_settings; kinds must outlive it. Begins without a grid.
    PickingSession(SettingsPtr settings, const EvolutionKinds& kinds);

    void apply(PickingCommand command);

    // Whether a grid is wanted, now or ahead of the next decision.
    bool has_work() const;
    // Goes on making it, at most to the end of a generation. False if stopped.
    bool work(EvaluationBackend& backend, EvaluationProgress& progress,
              const std::stop_token& stop);
    // Gives up what is being made, and says why.
    void fail(std::string message);

    const PickingSnapshot& snapshot() const { return shown_; }

private:
    // A grid being made.
    struct Work {
        GridNode draft;  // as it will be in the tree, but for its creatures
        GridOrder order;
        std::optional<Assistance> assistance;  // first, for the order's pool
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
