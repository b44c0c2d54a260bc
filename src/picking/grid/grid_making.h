#pragma once

// Makes one grid: breeds candidates, has them evaluated, chooses. May be interrupted at any time
// and goes on where it was; what comes out depends on the order alone.

#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/kinds/evolution_kinds.h"
#include "picking/grid/grid_breeding.h"
#include "picking/grid/grid_choice.h"

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <stop_token>
#include <vector>

namespace cambrian {

struct GridOrder {
    std::uint32_t node = 0;  // number of the grid in the tree
    int cells = 12;
    int newcomer_cells = 0;   // kept free for random creatures; needs parents
    int extra_mutations = 0;  // a child; one more in each further round of breeding
    double fitness_weight = 0.0;
    std::vector<IndividualPtr> parents;         // 0 to kMostPicks; see plan_brood()
    std::map<std::size_t, IndividualPtr> kept;  // by cell; shown whatever they are
    // Candidates there are already. If too few of them live, all that do are shown, with others
    // bred; an order with a pool has no newcomers' cells.
    std::vector<IndividualPtr> pool;
};

class GridMaking {
public:
    // Creatures with a score must have it by these settings.
    GridMaking(GridOrder order, SettingsPtr settings, const EvolutionKinds& kinds);

    // False if stopped; the call may be repeated to go on.
    bool run(EvaluationBackend& backend, EvaluationProgress& progress, const std::stop_token& stop);
    bool done() const { return done_; }
    // All cells, once done. Those not kept are in the order of their uids, from which nothing can
    // be read.
    const std::vector<IndividualPtr>& cells() const { return cells_; }

private:
    bool evaluate_open(EvaluationBackend& backend, EvaluationProgress& progress,
                       const std::stop_token& stop);
    void request_unknown(const std::vector<IndividualPtr>& creatures);
    void score(std::vector<IndividualPtr>& creatures) const;
    void breed_round();
    std::size_t offspring_places() const;
    std::set<std::uint64_t> taken_hashes() const;
    std::size_t living(const std::vector<IndividualPtr>& candidates) const;
    bool enough() const;
    void choose();
    void choose_from(const std::vector<IndividualPtr>& candidates, std::size_t places,
                     std::vector<IndividualPtr>& shown) const;

    GridOrder order_;
    SettingsPtr settings_;
    const EvolutionKinds* kinds_;
    std::vector<IndividualPtr> kept_;
    std::vector<IndividualPtr> offspring_;  // and everyone where no cells are kept for newcomers
    std::vector<IndividualPtr> newcomers_;
    int rounds_ = 0;
    bool done_ = false;
    std::vector<IndividualPtr> cells_;

    std::map<std::uint64_t, EvaluationResult> known_;  // by genome hash
    std::map<std::uint64_t, std::size_t> requested_;   // by genome hash
    std::vector<EvaluationRequest> requests_;
    std::vector<std::optional<EvaluationResult>> results_;  // one a request
};

}  // namespace cambrian
