#pragma once

// Makes one grid: breeds candidates, evaluates them and chooses. It can be interrupted at any time
// and continued; the result depends on the order alone.

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
    int immigrant_cells = 0;  // cells reserved for random creatures; more than 0 needs parents
    int extra_mutations = 0;  // per child; each further round of breeding adds one
    double fitness_weight = 0.0;
    std::vector<IndividualPtr> parents;         // 0 to kMostPicks; see plan_candidates()
    std::map<std::size_t, IndividualPtr> kept;  // creatures shown in any case, by cell
    // Candidates that exist already. If fewer of them are alive than there are cells, all of these
    // are shown and the rest is bred. An order with a pool reserves no cells for random creatures.
    std::vector<IndividualPtr> pool;
};

class GridMaking {
public:
    // Creatures with a score must have been evaluated with these settings.
    GridMaking(GridOrder order, SettingsPtr settings, const EvolutionKinds& kinds);

    // Returns false if it was stopped; it may then be called again to continue.
    bool run(EvaluationBackend& backend, EvaluationProgress& progress, const std::stop_token& stop);
    bool done() const { return done_; }
    // Returns all cells when done. Creatures that were not kept are ordered by uid, so that their
    // order says nothing about them.
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
    // Offspring; includes the random creatures unless cells are reserved for them.
    std::vector<IndividualPtr> offspring_;
    std::vector<IndividualPtr> immigrants_;
    int rounds_ = 0;
    bool done_ = false;
    std::vector<IndividualPtr> cells_;

    std::map<std::uint64_t, EvaluationResult> known_;  // by genome hash
    std::map<std::uint64_t, std::size_t> requested_;   // by genome hash
    std::vector<EvaluationRequest> requests_;
    std::vector<std::optional<EvaluationResult>> results_;  // one per request
};

}  // namespace cambrian
