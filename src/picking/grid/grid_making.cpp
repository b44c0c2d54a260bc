#include "picking/grid/grid_making.h"

#include "evolution/evaluation/trials.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cambrian {
namespace {

// Rounds of breeding before the remaining cells get the least bad candidates.
constexpr int kMostRounds = 4;
constexpr std::array kGrades = {CandidateGrade::kAlive, CandidateGrade::kStatic,
                                CandidateGrade::kRejected, CandidateGrade::kTwin,
                                CandidateGrade::kInvalid};

void append(std::vector<IndividualPtr>& all, const std::vector<IndividualPtr>& more) {
    all.insert(all.end(), more.begin(), more.end());
}

}  // namespace

GridMaking::GridMaking(GridOrder order, SettingsPtr settings, const EvolutionKinds& kinds)
    : order_(std::move(order)), settings_(std::move(settings)), kinds_(&kinds) {
    for (const auto& [cell, creature] : order_.kept)
        kept_.push_back(creature);
    offspring_ = order_.pool;
    for (const auto* group : {&kept_, &order_.parents, &order_.pool}) {
        for (const IndividualPtr& creature : *group) {
            if (creature->evaluated) known_.emplace(creature->genome_hash, creature->result);
        }
    }
}

bool GridMaking::run(EvaluationBackend& backend, EvaluationProgress& progress,
                     const std::stop_token& stop) {
    while (!done_) {
        if (!evaluate_open(backend, progress, stop)) return false;
        if (enough() || rounds_ == kMostRounds) {
            choose();
        } else {
            breed_round();
        }
    }
    return true;
}

bool GridMaking::evaluate_open(EvaluationBackend& backend, EvaluationProgress& progress,
                               const std::stop_token& stop) {
    if (requests_.empty()) {
        for (const auto* group : {&kept_, &offspring_, &immigrants_})
            request_unknown(*group);
        results_.assign(requests_.size(), std::nullopt);
    }
    if (!requests_.empty() && !backend.evaluate(requests_, results_, *settings_, progress, stop))
        return false;
    for (const auto& [hash, request] : requested_)
        known_.emplace(hash, *results_[request]);
    for (auto* group : {&kept_, &offspring_, &immigrants_})
        score(*group);
    requested_.clear();
    requests_.clear();
    results_.clear();
    return true;
}

// Requests one evaluation per genome; creatures with equal genomes share its result.
void GridMaking::request_unknown(const std::vector<IndividualPtr>& creatures) {
    for (const IndividualPtr& creature : creatures) {
        if (creature->evaluated || known_.count(creature->genome_hash) > 0) continue;
        if (!requested_.emplace(creature->genome_hash, requests_.size()).second) continue;
        requests_.push_back({.genome = creature->genome,
                             .trial_seed = trial_seed(*settings_),
                             .slot = static_cast<std::uint32_t>(requests_.size()),
                             .expected_work = creature->expected_work});
    }
}

void GridMaking::score(std::vector<IndividualPtr>& creatures) const {
    for (IndividualPtr& creature : creatures) {
        if (creature->evaluated) continue;
        Individual scored = *creature;
        scored.result = known_.at(creature->genome_hash);
        scored.evaluated = true;
        creature = std::make_shared<const Individual>(std::move(scored));
    }
}

// Breeds more candidates. Each further round mutates more, since too few candidates were alive.
void GridMaking::breed_round() {
    Candidates candidates = breed_candidates({.parents = order_.parents,
                                              .cells = order_.cells,
                                              .immigrant_cells = order_.immigrant_cells,
                                              .extra_mutations = order_.extra_mutations + rounds_,
                                              .node = order_.node,
                                              .round = rounds_},
                                             *settings_, *kinds_);
    ++rounds_;
    append(offspring_, candidates.offspring);
    append(order_.immigrant_cells > 0 ? immigrants_ : offspring_, candidates.immigrants);
}

std::size_t GridMaking::offspring_places() const {
    return static_cast<std::size_t>(order_.cells - order_.immigrant_cells) - kept_.size();
}

std::set<std::uint64_t> GridMaking::taken_hashes() const {
    std::set<std::uint64_t> taken;
    for (const auto* group : {&kept_, &order_.parents}) {
        for (const IndividualPtr& creature : *group)
            taken.insert(creature->genome_hash);
    }
    return taken;
}

std::size_t GridMaking::living(const std::vector<IndividualPtr>& candidates) const {
    const std::vector<CandidateGrade> grades = grade_candidates(candidates, taken_hashes());
    return static_cast<std::size_t>(
        std::count(grades.begin(), grades.end(), CandidateGrade::kAlive));
}

bool GridMaking::enough() const {
    return living(offspring_) >= offspring_places() &&
           living(immigrants_) >= static_cast<std::size_t>(order_.immigrant_cells);
}

void GridMaking::choose() {
    std::vector<IndividualPtr> shown = kept_;
    choose_from(offspring_, offspring_places(), shown);
    choose_from(immigrants_, static_cast<std::size_t>(order_.immigrant_cells), shown);
    const auto first = shown.begin() + static_cast<std::ptrdiff_t>(kept_.size());
    std::stable_sort(first, shown.end(), [](const IndividualPtr& a, const IndividualPtr& b) {
        return a->uid < b->uid;
    });
    auto kept = kept_.begin();
    auto chosen = first;
    for (std::size_t cell = 0; cell < static_cast<std::size_t>(order_.cells); ++cell)
        cells_.push_back(order_.kept.count(cell) > 0 ? *kept++ : *chosen++);
    done_ = true;
}

// Chooses living candidates first and then, while cells are empty, the least bad. Among equally
// good ones, those of the pool come first.
void GridMaking::choose_from(const std::vector<IndividualPtr>& candidates, std::size_t places,
                             std::vector<IndividualPtr>& shown) const {
    const std::vector<CandidateGrade> grades = grade_candidates(candidates, taken_hashes());
    const std::size_t full = shown.size() + places;
    const auto take = [&](CandidateGrade grade, std::size_t begin, std::size_t end) {
        std::vector<IndividualPtr> equals;
        for (std::size_t i = begin; i < end; ++i) {
            if (grades[i] == grade) equals.push_back(candidates[i]);
        }
        for (const std::size_t index :
             choose_diverse(equals, shown, full - shown.size(), order_.fitness_weight))
            shown.push_back(equals[index]);
    };
    const std::size_t pool = std::min(order_.pool.size(), candidates.size());
    for (const CandidateGrade grade : kGrades) {
        take(grade, 0, pool);
        take(grade, pool, candidates.size());
    }
}

}  // namespace cambrian
