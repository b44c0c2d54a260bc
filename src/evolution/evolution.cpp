#include "evolution/evolution.h"

#include "breeding/mutation.h"
#include "evolution/evaluation/terrain_ladder.h"
#include "evolution/evaluation/trials.h"
#include "evolution/generation.h"
#include "evolution/individual/map_axis.h"
#include "evolution/opponents.h"
#include "evolution/selections/survival.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kNoRequest = static_cast<std::size_t>(-1);
constexpr std::uint64_t kAuditedOneIn = 10;  // one terminated trial in so many is finished anyway
constexpr std::size_t kChampions = 20;       // best survivors among whom the champion is chosen
constexpr int kChampionWorlds = 10;          // number of worlds in which these are evaluated again

}  // namespace

Evolution::Evolution(SettingsPtr settings, const EvolutionKinds& kinds,
                     const std::vector<GenomePtr>& founders)
    : settings_(std::move(settings)), kinds_(&kinds), founders_(founders) {
    const auto size = static_cast<std::size_t>(settings_->population.size);
    for (std::size_t slot = 0; slot < size; ++slot)
        population_.push_back(make_founder(slot));
}

Evolution::Evolution(EvolutionState state, const EvolutionKinds& kinds)
    : settings_(std::move(state.settings)),
      kinds_(&kinds),
      generation_(state.generation),
      evaluated_(true),
      memory_(std::move(state.memory)),
      population_(std::move(state.population)),
      history_(std::move(state.history)),
      termination_audit_(state.termination_audit),
      champions_(std::move(state.champions)),
      founders_(std::move(state.founders)) {}

IndividualPtr Evolution::make_founder(std::size_t slot) const {
    const bool given_place = slot < founders_.size();
    const PopulationSettings& rules = settings_->population;
    const bool random = rules.fill == "random" || rules.museum > 0.0;
    if (founders_.empty() || (!given_place && random))
        return make_immigrant(*settings_, *kinds_, 0, slot);
    const GenomePtr& given = founders_[slot % founders_.size()];
    if (given_place) {
        return std::make_shared<const Individual>(
            make_individual(given, *settings_, 0, slot, "imported"));
    }
    Genome genome = *given;
    RandomStream stream(stream_seed(settings_->seed, 0, slot, Purpose::kMutation));
    std::vector<MutationRecord> mutations =
        mutate(genome, settings_->mutation, kinds_->mutations,
               {.catalog = kinds_->creature.catalog, .founders = settings_->founders}, stream);
    Individual mutant = make_individual(std::make_shared<const Genome>(std::move(genome)),
                                        *settings_, 0, slot, "imported");
    mutant.mutations = std::move(mutations);
    return std::make_shared<const Individual>(std::move(mutant));
}

bool Evolution::evaluate(EvaluationBackend& backend, EvaluationProgress& progress,
                         const std::stop_token& stop) {
    if (evaluated_) return true;
    if (!climb_ladder(backend, stop)) return false;
    if (std::exchange(renewal_due_, false)) renew_chance();
    meet_opponents();
    plan_evaluations();
    if (!backend.evaluate(requests_, results_, *settings_, progress, stop)) return false;
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
    const std::vector<Probe> probes =
        probes_of(*settings_, generation_, settings_->selection.confirmations);
    const auto survivors = [this](std::span<const IndividualPtr> all) { return survivors_of(all); };
    if (!confirmation_.confirm(ranked, survivors, probes,
                               {backend, *settings_, progress, stop, least_score()}))
        return false;
    population_ = std::move(ranked);
    record_generation();
    forget_plan();
    evaluated_ = true;
    return true;
}

double Evolution::least_score() const {
    return kinds_->goals.find(settings_->goal)->least_score;
}

// Returns the survivors if the generation were bred now.
std::vector<std::size_t> Evolution::survivors_of(std::span<const IndividualPtr> ranked) const {
    return cambrian::survivors_of(ranked, *settings_, *kinds_, generation_ + 1, memory_);
}

std::optional<IndividualPtr> Evolution::confirmed_champion(EvaluationBackend& backend,
                                                           EvaluationProgress& progress,
                                                           std::stop_token stop) const {
    CAMBRIAN_ASSERT(evaluated_, "only an evaluated generation has a champion");
    if (settings_->selection.confirmations == 0) return population_.front();
    std::vector<IndividualPtr> candidates;
    for (const std::size_t survivor : survivors_of(population_)) {
        Individual fresh = *population_[survivor];
        fresh.result.fitness = unconfirmed_score(fresh.result);
        fresh.result.scores.clear();
        candidates.push_back(std::make_shared<const Individual>(std::move(fresh)));
        if (candidates.size() == kChampions) break;
    }
    // The first worlds of a generation were used to choose survivors; these are different ones.
    const std::vector<Probe> probes =
        probes_of(*settings_, generation_, settings_->selection.confirmations + kChampionWorlds);
    const auto others = std::span(probes).last(kChampionWorlds);
    Confirmation confirmation;
    if (!confirmation.confirm(candidates, everybody, others,
                              {backend, *settings_, progress, stop, least_score()}))
        return std::nullopt;
    const ExperimentSettings accurate = accurate_settings(*settings_, *kinds_);
    const auto champion =
        std::find_if(candidates.begin(), candidates.end(), [&](const IndividualPtr& one) {
            return is_accurate(*one, {backend, accurate, progress, stop});
        });
    if (stop.stop_requested()) return std::nullopt;
    return champion != candidates.end() ? *champion : candidates.front();
}

void Evolution::record_generation() {
    GenerationStatistics statistics = summarize(
        population_, generation_, static_cast<int>(requests_.size()) + confirmation_.trials());
    statistics.confirmations = confirmation_.trials();
    count_lines(statistics, population_, survivors_of(population_));
    const TrialSettings& trial = settings_->world.trial;
    const auto unscored =
        static_cast<int>(std::count_if(request_of_slot_.begin(), request_of_slot_.end(),
                                       [](std::size_t request) { return request != kNoRequest; }));
    const int twins = unscored - static_cast<int>(requests_.size());
    count_savings(statistics, results_, known_scores_ + twins, trial.duration * trial.trials);
    for (const auto& result : results_)
        termination_audit_.finished +=
            result->terminable && result->outcome == Outcome::kCompleted ? 1 : 0;
    statistics.giving_up_distrusted = !termination_audit_.trustworthy();
    const MapCoverage coverage = map_coverage(population_, *settings_);
    statistics.filled_cells = coverage.filled_cells;
    statistics.quality = coverage.quality;
    statistics.terrain_level = settings_->world.environment.terrain.level;
    if (!history_.empty() && !judged_anew_) continue_progress(statistics, history_.back());
    judged_anew_ = false;
    history_.push_back(statistics);
}

// Makes one request for each new phenotype; creatures with the same phenotype share its score.
void Evolution::plan_evaluations() {
    if (!request_of_slot_.empty()) return;
    std::map<std::uint64_t, std::size_t> requested;  // request of each phenotype
    request_of_slot_.assign(population_.size(), kNoRequest);
    for (std::size_t slot = 0; slot < population_.size(); ++slot) {
        const Individual& individual = *population_[slot];
        if (individual.evaluated) continue;
        const PhenotypeHashes hashes = hashes_of(*individual.genome, *settings_, *kinds_);
        if (score_as_known(slot, hashes.phenotype)) continue;
        const auto [request, is_new] = requested.emplace(hashes.phenotype, requests_.size());
        request_of_slot_[slot] = request->second;
        if (!is_new) continue;
        requests_.push_back({individual.genome, trial_seed(*settings_),
                             static_cast<std::uint32_t>(slot),
                             threshold_for(individual, hashes.plan), individual.expected_work});
    }
    results_.assign(requests_.size(), std::nullopt);
}

// Copies the score of a creature of the last generation with the same phenotype, if there is one.
bool Evolution::score_as_known(std::size_t slot, std::uint64_t phenotype) {
    const auto known = known_results_.find(phenotype);
    if (known == known_results_.end()) return false;
    Individual scored = *population_[slot];
    scored.result = known->second;
    scored.result.terminable = false;  // it was audited when it was first evaluated
    scored.evaluated = true;
    population_[slot] = std::make_shared<const Individual>(std::move(scored));
    ++known_scores_;
    return true;
}

std::optional<TerminationThreshold> Evolution::threshold_for(const Individual& individual,
                                                             std::uint64_t plan) const {
    if (!settings_->terminate_early || !termination_audit_.trustworthy()) return {};
    const std::optional<double> least = survival_thresholds_.of(individual.line, plan);
    if (!least) return {};
    const bool drawn = individual.uid % kAuditedOneIn == 0;
    return TerminationThreshold{.score = *least, .audited = drawn || !termination_audit_.proven()};
}

// Computes the scores that creatures of the next generation need to survive, as far as they are
// known. It also counts audited trials that survived although they would have been terminated.
void Evolution::update_thresholds(const std::vector<IndividualPtr>& next) {
    std::vector<IndividualPtr> survivors;
    for (const IndividualPtr& individual : next) {
        if (!individual->evaluated) continue;
        if (individual->born + 1 == generation_ && individual->result.terminable)
            ++termination_audit_.survived;
        survivors.push_back(individual);
    }
    survival_thresholds_ = {};
    if (!scores_outdated_) {
        survival_thresholds_ = SurvivalThresholds(
            survivors, *settings_, *kinds_->selections.find(settings_->selection.method));
    }
}

void Evolution::forget_plan() {
    requests_.clear();
    results_.clear();
    request_of_slot_.clear();
    confirmation_.forget();
}

void Evolution::breed() {
    CAMBRIAN_ASSERT(evaluated_, "only an evaluated generation breeds");
    ++generation_;
    champions_.push_back(population_.front()->genome);
    const auto renewal = static_cast<std::uint32_t>(settings_->world.trial.renewal);
    renewal_due_ = renewal > 0 && generation_ % renewal == 0;
    ExperimentSettings present = *settings_;
    const auto immigrants = std::lround(immigrant_share_ * present.population.size);
    present.population.immigrants += static_cast<int>(immigrants);
    immigrant_share_ = 0.0;
    std::vector<IndividualPtr> next =
        next_generation(population_, present, *kinds_, generation_, memory_);
    update_thresholds(next);
    known_scores_ = 0;
    remember_scores();
    if (scores_outdated_) {
        forget_scores(next);
        memory_ = {};
    }
    scores_outdated_ = false;
    invite_founder();
    place_injected(next);
    population_ = std::move(next);
    evaluated_ = false;
}

// The founders from a museum come back, one a generation, in order.
void Evolution::invite_founder() {
    if (settings_->population.museum > 0.0 && !founders_.empty())
        inject(founders_[generation_ % founders_.size()]);
}

void Evolution::place_injected(std::vector<IndividualPtr>& next) {
    for (std::size_t i = 0; i < injected_.size() && i + 1 < next.size(); ++i) {
        const std::size_t slot = next.size() - 1 - i;
        next[slot] = std::make_shared<const Individual>(
            make_individual(injected_[i], *settings_, generation_, next.size() + i, "imported"));
    }
    injected_.clear();
}

void Evolution::remember_scores() {
    known_results_.clear();
    if (scores_outdated_) return;
    for (const IndividualPtr& individual : population_)
        known_results_.emplace(individual->result.phenotype, individual->result);
}

// Draws the places of the light and jitter again, which discards all scores.
void Evolution::renew_chance() {
    ExperimentSettings renewed = *settings_;
    ++renewed.world.trial.draw;
    replace_settings(std::make_shared<const ExperimentSettings>(std::move(renewed)));
}

// Raises the level of the terrain if the survivors are ready for it, which discards all scores.
// Returns false if stopped; the call may be repeated.
bool Evolution::climb_ladder(EvaluationBackend& backend, const std::stop_token& stop) {
    if (!request_of_slot_.empty() || !climbs_ladder(*settings_)) return true;
    const IndividualPtr median = median_survivor(population_, generation_);
    if (!median) return true;
    const std::optional<bool> ready = is_ready_to_climb(*median, *settings_, backend, stop);
    if (!ready) return false;
    if (*ready) replace_settings(on_next_level(*settings_));
    return true;
}

// Draws the opponents of this generation, which discards all scores.
void Evolution::meet_opponents() {
    const TrialWorld& world = settings_->world;
    Opponents drawn;
    if (kinds_->goals.find(settings_->goal)->is_contest) {
        if (opponents_drawn_ == generation_ && !world.opponents.genomes.empty()) return;
        drawn = draw_opponents({champions_, population_}, *settings_, generation_);
        opponents_drawn_ = generation_;
    }
    if (drawn == world.opponents) return;
    ExperimentSettings changed = *settings_;
    changed.world.opponents = std::move(drawn);
    take_settings(std::make_shared<const ExperimentSettings>(std::move(changed)));
}

void Evolution::replace_settings(SettingsPtr settings) {
    const TrialWorld& present = settings_->world;
    const TerrainSettings& ground = present.environment.terrain;
    const TerrainSettings& wanted = settings->world.environment.terrain;
    const bool lowers_ladder = ground.ladder && wanted.ladder && wanted.level < ground.level;
    if (settings->world.trial.draw < present.trial.draw || lowers_ladder ||
        !(settings->world.opponents == present.opponents)) {
        ExperimentSettings kept = *settings;
        if (lowers_ladder) kept.world.environment.terrain.level = ground.level;
        kept.world.trial.draw = std::max(kept.world.trial.draw, present.trial.draw);
        kept.world.opponents = present.opponents;
        settings = std::make_shared<const ExperimentSettings>(std::move(kept));
    }
    take_settings(std::move(settings));
}

void Evolution::take_settings(SettingsPtr settings) {
    const bool keeps_scores = same_judgement(*settings_, *settings);
    const bool keeps_threshold = settings_->terminate_early == settings->terminate_early;
    settings_ = std::move(settings);
    // The plan must depend only on the present settings, not on when they were set.
    if (!keeps_threshold) forget_plan();
    if (!keeps_scores) rescore();
}

void Evolution::rescore() {
    forget_plan();
    memory_ = {};
    judged_anew_ = true;
    survival_thresholds_ = {};
    known_scores_ = 0;
    known_results_.clear();
    if (evaluated_) {
        scores_outdated_ = true;  // the old scores still decide which creatures breed
    } else {
        forget_scores(population_);
    }
}

void Evolution::forget_scores(std::vector<IndividualPtr>& population) {
    for (IndividualPtr& individual : population) {
        if (individual->evaluated) individual = without_score(*individual);
    }
}

void Evolution::inject(GenomePtr genome) {
    injected_.push_back(std::move(genome));
}

void Evolution::add_immigrants(double share) {
    immigrant_share_ = std::clamp(immigrant_share_ + share, 0.0, 1.0);
}

}  // namespace cambrian
