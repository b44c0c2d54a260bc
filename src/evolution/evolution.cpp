#include "evolution/evolution.h"

#include "breeding/mutation.h"
#include "evolution/generation.h"
#include "genome/random_genome.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

// Scores stay valid only while everything they depend on does.
bool same_judgement(const ExperimentSettings& a, const ExperimentSettings& b) {
    return a.goal == b.goal && a.world == b.world && a.expression == b.expression;
}

}  // namespace

Evolution::Evolution(SettingsPtr settings, const EvolutionKinds& kinds,
                     const std::vector<GenomePtr>& founders)
    : settings_(std::move(settings)), kinds_(&kinds) {
    const auto size = static_cast<std::size_t>(settings_->population.size);
    for (std::size_t slot = 0; slot < size; ++slot) {
        population_.push_back(make_founder(slot, founders));
    }
}

IndividualPtr Evolution::make_founder(std::size_t slot,
                                      const std::vector<GenomePtr>& founders) const {
    const KindCatalog& catalog = kinds_->creature.catalog;
    if (founders.empty()) {
        RandomStream stream(stream_seed(settings_->seed, 0, slot, Purpose::kFounder));
        auto genome =
            std::make_shared<const Genome>(random_genome(settings_->founders, catalog, stream));
        return std::make_shared<const Individual>(
            make_individual(std::move(genome), *settings_, 0, slot, "random"));
    }
    const GenomePtr& given = founders[slot % founders.size()];
    if (slot < founders.size()) {
        return std::make_shared<const Individual>(
            make_individual(given, *settings_, 0, slot, "imported"));
    }
    Genome genome = *given;
    RandomStream stream(stream_seed(settings_->seed, 0, slot, Purpose::kMutation));
    std::vector<MutationRecord> mutations =
        mutate(genome, settings_->mutation, kinds_->mutations,
               {.catalog = catalog, .founders = settings_->founders}, stream);
    Individual mutant = make_individual(std::make_shared<const Genome>(std::move(genome)),
                                        *settings_, 0, slot, "imported");
    mutant.mutations = std::move(mutations);
    return std::make_shared<const Individual>(std::move(mutant));
}

bool Evolution::evaluate(EvaluationBackend& backend, EvaluationProgress& progress,
                         std::stop_token stop) {
    if (evaluated_) return true;
    plan_evaluations();
    if (!backend.evaluate(requests_, results_, *settings_, progress, std::move(stop))) return false;
    std::vector<IndividualPtr> ranked;
    for (std::size_t slot = 0; slot < population_.size(); ++slot) {
        if (population_[slot]->evaluated) {
            ranked.push_back(population_[slot]);
            continue;
        }
        Individual scored = *population_[slot];
        scored.result = *results_[request_of_slot_[slot]];
        scored.evaluated = true;
        ranked.push_back(std::make_shared<const Individual>(std::move(scored)));
    }
    std::sort(ranked.begin(), ranked.end(),
              [](const IndividualPtr& a, const IndividualPtr& b) { return better(*a, *b); });
    population_ = std::move(ranked);
    history_.push_back(summarize(population_, generation_, static_cast<int>(requests_.size())));
    forget_plan();
    evaluated_ = true;
    return true;
}

// One request for every distinct genome without a score; creatures that share a genome share it.
void Evolution::plan_evaluations() {
    if (!request_of_slot_.empty()) return;
    std::multimap<std::uint64_t, std::size_t> requested;  // genome hash to request
    request_of_slot_.assign(population_.size(), 0);
    for (std::size_t slot = 0; slot < population_.size(); ++slot) {
        const Individual& individual = *population_[slot];
        if (individual.evaluated) continue;
        const auto [first, last] = requested.equal_range(individual.genome_hash);
        const auto twin = std::find_if(first, last, [&](const auto& entry) {
            return *requests_[entry.second].genome == *individual.genome;
        });
        if (twin != last) {
            request_of_slot_[slot] = twin->second;
            continue;
        }
        request_of_slot_[slot] = requests_.size();
        requested.emplace(individual.genome_hash, requests_.size());
        requests_.push_back({individual.genome, stream_seed(settings_->seed, 0, 0, Purpose::kTrial),
                             static_cast<std::uint32_t>(slot)});
    }
    results_.assign(requests_.size(), std::nullopt);
}

void Evolution::forget_plan() {
    requests_.clear();
    results_.clear();
    request_of_slot_.clear();
}

void Evolution::breed() {
    CAMBRIAN_ASSERT(evaluated_, "only an evaluated generation breeds");
    ++generation_;
    std::vector<IndividualPtr> next =
        next_generation(population_, *settings_, *kinds_, generation_);
    if (scores_outdated_) {
        forget_scores(next);
    } else {
        share_known_scores(next);
    }
    scores_outdated_ = false;
    for (std::size_t i = 0; i < injected_.size() && i + 1 < next.size(); ++i) {
        const std::size_t slot = next.size() - 1 - i;
        next[slot] = std::make_shared<const Individual>(
            make_individual(injected_[i], *settings_, generation_, next.size() + i, "imported"));
    }
    injected_.clear();
    population_ = std::move(next);
    evaluated_ = false;
}

// A child that is a clone of somebody of the last generation has that creature's score.
void Evolution::share_known_scores(std::vector<IndividualPtr>& next) const {
    std::multimap<std::uint64_t, const Individual*> known;
    for (const IndividualPtr& individual : population_) {
        known.emplace(individual->genome_hash, individual.get());
    }
    for (IndividualPtr& individual : next) {
        if (individual->evaluated) continue;
        const auto [first, last] = known.equal_range(individual->genome_hash);
        const auto twin = std::find_if(first, last, [&](const auto& entry) {
            return *entry.second->genome == *individual->genome;
        });
        if (twin == last) continue;
        Individual scored = *individual;
        scored.result = twin->second->result;
        scored.evaluated = true;
        individual = std::make_shared<const Individual>(std::move(scored));
    }
}

void Evolution::replace_settings(SettingsPtr settings) {
    const bool keeps_scores = same_judgement(*settings_, *settings);
    settings_ = std::move(settings);
    if (keeps_scores) return;
    forget_plan();
    if (evaluated_) {
        scores_outdated_ = true;  // they still decide who breeds
    } else {
        forget_scores(population_);
    }
}

void Evolution::forget_scores(std::vector<IndividualPtr>& population) {
    for (IndividualPtr& individual : population) {
        if (!individual->evaluated) continue;
        Individual unscored = *individual;
        unscored.evaluated = false;
        unscored.result = {};
        individual = std::make_shared<const Individual>(std::move(unscored));
    }
}

void Evolution::inject(GenomePtr genome) {
    injected_.push_back(std::move(genome));
}

}  // namespace cambrian
