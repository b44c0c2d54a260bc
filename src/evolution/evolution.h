#pragma once

// Evolution without threads: a population that is evaluated and bred, generation by generation. The
// command line uses it directly, the studio through the engine's thread.

#include "evolution/evaluation/confirmation.h"
#include "evolution/evaluation/evaluation_backend.h"
#include "evolution/individual/statistics.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/selections/survival_thresholds.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace cambrian {

// The state of a run after a generation was evaluated and before the next is bred.
struct EvolutionState {
    SettingsPtr settings;  // settings that evaluated the generation
    std::uint32_t generation = 0;
    std::vector<IndividualPtr> population;  // all evaluated, best first; not empty
    std::vector<GenerationStatistics> history;
    SelectionMemory memory;
    TerminationAudit termination_audit;
    std::vector<GenomePtr> champions;  // the best of each generation before this one, in order
    std::vector<GenomePtr> founders;   // those that were given; one a generation joins again, if
                                       // the settings take founders from a museum
};

class Evolution {
public:
    // The settings must pass check_settings(). `founders` are genomes of generation 0. The settings
    // say whether their mutants or random creatures take the remaining places, and whether they
    // join again later. Without founders, all are random.
    Evolution(SettingsPtr settings, const EvolutionKinds& kinds,
              const std::vector<GenomePtr>& founders = {});
    // Continues from a state.
    Evolution(EvolutionState state, const EvolutionKinds& kinds);

    // Evaluates the present generation. Returns false if stopped; finished trials are kept and the
    // call may be repeated.
    bool evaluate(EvaluationBackend& backend, EvaluationProgress& progress,
                  const std::stop_token& stop);

    // Returns the audited champion: the best of the survivors, confirmed in ten more slightly
    // changed worlds, whose score an accurate computation (is_accurate()) changes by at most a
    // tenth; if there is none, the best of them. Without confirmation in the settings, it is the
    // best by score. Returns nothing if stopped. Must be called after evaluate().
    std::optional<IndividualPtr> confirmed_champion(EvaluationBackend& backend,
                                                    EvaluationProgress& progress,
                                                    std::stop_token stop) const;

    // Replaces the generation by survivors and offspring. Must be called after evaluate().
    void breed();

    // Changes the settings from the next breed() or evaluate() on. A change of world or goal
    // discards all scores. The number of draws and the level of a ladder never decrease, and
    // opponents stay those that were drawn.
    void replace_settings(SettingsPtr settings);
    // Discards all scores: the next evaluate() evaluates all creatures again. Scores of a
    // generation that is already evaluated still decide who breeds.
    void rescore();
    // Gives this one the last place of the next generation, that of an immigrant or a child. All
    // but one of the places can be given so; further creatures are not taken.
    void inject(GenomePtr genome);
    // Gives a share (0 to 1) of the next offspring places, once, to random immigrants.
    void add_immigrants(double share);

    const ExperimentSettings& settings() const { return *settings_; }
    SettingsPtr shared_settings() const { return settings_; }
    std::uint32_t generation() const { return generation_; }
    bool evaluated() const { return evaluated_; }
    // Sorted best first after evaluate(); in the order of slots before.
    const std::vector<IndividualPtr>& population() const { return population_; }
    const std::vector<GenerationStatistics>& history() const { return history_; }
    const SelectionMemory& selection_memory() const { return memory_; }
    // Reliability of early termination; once it is unreliable, no more trials are terminated.
    const TerminationAudit& termination_audit() const { return termination_audit_; }

private:
    IndividualPtr make_founder(std::size_t slot) const;
    void plan_evaluations();
    std::vector<std::size_t> survivors_of(std::span<const IndividualPtr> ranked) const;
    std::optional<TerminationThreshold> threshold_for(const Individual& individual,
                                                      std::uint64_t plan) const;
    void update_thresholds(const std::vector<IndividualPtr>& next);
    void forget_plan();
    double least_score() const;
    void renew_chance();
    bool climb_ladder(EvaluationBackend& backend, const std::stop_token& stop);
    void take_settings(SettingsPtr settings);
    void meet_opponents();
    bool score_as_known(std::size_t slot, std::uint64_t phenotype);
    void remember_scores();
    void record_generation();
    void invite_founder();
    void place_injected(std::vector<IndividualPtr>& next);
    static void forget_scores(std::vector<IndividualPtr>& population);

    SettingsPtr settings_;
    const EvolutionKinds* kinds_;
    std::uint32_t generation_ = 0;
    bool evaluated_ = false;
    bool scores_outdated_ = false;  // the settings that evaluated the population were replaced
    // This generation's scores cannot be compared with those of the last.
    bool judged_anew_ = false;
    bool renewal_due_ = false;  // chance is renewed before this generation is evaluated
    SelectionMemory memory_;
    std::vector<IndividualPtr> population_;
    std::vector<GenomePtr> injected_;
    // Share of the next offspring, besides the immigrants of the settings.
    double immigrant_share_ = 0.0;
    std::vector<GenerationStatistics> history_;

    SurvivalThresholds survival_thresholds_;
    TerminationAudit termination_audit_;
    std::vector<GenomePtr> champions_;  // the best of each generation before this one
    std::vector<GenomePtr> founders_;   // those that were given
    // Generation for which opponents were drawn last.
    std::optional<std::uint32_t> opponents_drawn_;
    // Results of the last generation, by phenotype.
    std::map<std::uint64_t, EvaluationResult> known_results_;
    int known_scores_ = 0;  // number of creatures of this generation with such a result

    // The present generation's evaluations; empty when there are none to do.
    std::vector<EvaluationRequest> requests_;
    std::vector<std::optional<EvaluationResult>> results_;  // one per request
    std::vector<std::size_t> request_of_slot_;
    Confirmation confirmation_;
};

}  // namespace cambrian
