#include "evolution/evaluation/evaluation.h"

#include "creature/body_plan_hash.h"
#include "creature/overlap.h"
#include "creature/phenotype_hash.h"
#include "evolution/evaluation/trials.h"
#include "simulator/audit.h"
#include "simulator/trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

// Expected work of a repetition, as a multiple of the suspect trial's.
constexpr std::uint64_t kSuspectWork = 10;
constexpr double kSuspectPenalty = 2.0;  // divides the score, simulator/README.md 4

EvaluationResult describe(const Phenotype& phenotype, const ExperimentSettings& settings) {
    EvaluationResult result;
    result.phenotype = phenotype_hash(phenotype);
    result.plan = body_plan_hash(phenotype);
    result.parts = static_cast<int>(phenotype.parts.size());
    result.neurons = static_cast<int>(phenotype.network.order.size());
    result.mass = phenotype.mass(settings.world.environment.density);
    result.body_length = phenotype.rest_length();
    return result;
}

void fail(EvaluationResult& result, const GoalKind& goal, Outcome outcome, std::string reason) {
    result.fitness = goal.least_score;
    result.outcome = outcome;
    result.reason = std::move(reason);
}

// Divides a positive score. A negative score stays, because division would improve it.
double scaled_down(double score, double divisor) {
    return score > 0.0 ? score / divisor : score;
}

// The score of one trial, and its shares of a score of all trials (GoalKind::shares).
struct Marks {
    double score = 0.0;
    std::vector<double> shares;

    void scale_down(double divisor) {
        score = scaled_down(score, divisor);
        for (double& share : shares)
            share = scaled_down(share, divisor);
    }
};

// Shaking scales the score down; see simulator/README.md 2.
Marks marks_of(const TrialRecord& record, const GoalKind& goal, const TrialSettings& trial) {
    if (record.outcome != Outcome::kCompleted && record.outcome != Outcome::kStoppedEarly)
        return {goal.least_score, {}};
    Marks marks{goal.score(record).value, {}};
    if (goal.shares != nullptr) marks.shares = goal.shares(record);
    const double shaking = record.reversal_rate / trial.max_reversal_rate;
    if (shaking > 1.0) marks.scale_down(shaking);
    return marks;
}

const GoalKind& goal_of(const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    const GoalKind* goal = kinds.goals.find(settings.goal);
    CAMBRIAN_ASSERT(goal != nullptr, "settings were checked");
    return *goal;
}

struct FinerTrial {
    FinerResult result;
    std::string reason;
    Marks marks = {};
};

FinerTrial run_finer(const std::shared_ptr<const Phenotype>& phenotype,
                     const ExperimentSettings& settings, const EvolutionKinds& kinds,
                     const std::stop_token& stop) {
    TrialWorld world = first_trial_world(settings);
    world.scene = finer_settings(world.scene, kinds.creature.scene);
    const auto record = run_trial(phenotype, kinds.creature, world, stop);
    const GoalKind& goal = goal_of(settings, kinds);
    if (!record)
        return {{.outcome = Outcome::kRejected, .score = goal.least_score}, record.error().message};
    Marks marks = marks_of(*record, goal, settings.world.trial);
    return {{.outcome = record->outcome, .score = marks.score, .verdict = judge(*record)},
            record->reason,
            std::move(marks)};
}

// A suspect trial is run again more finely; one that stays suspect keeps half its score.
void settle_suspicion(JudgedTrial& judged, const std::shared_ptr<const Phenotype>& phenotype,
                      const ExperimentSettings& settings, const EvolutionKinds& kinds,
                      const std::stop_token& stop) {
    FinerTrial finer = run_finer(phenotype, settings, kinds, stop);
    judged.result.finer = finer.result;
    if (finer.result.verdict != AuditVerdict::kClean) finer.marks.scale_down(kSuspectPenalty);
    judged.result.fitness = finer.marks.score;
    judged.shares = std::move(finer.marks.shares);
    if (finer.result.outcome != Outcome::kCompleted)
        fail(judged.result, goal_of(settings, kinds), finer.result.outcome,
             "when computed more finely: " + finer.reason);
}

}  // namespace

EvaluationResult evaluate(const EvaluationRequest& request, const ExperimentSettings& settings,
                          const EvolutionKinds& kinds, const std::stop_token& stop) {
    return judge_trial(request, settings, kinds, stop).result;
}

JudgedTrial judge_trial(const EvaluationRequest& request, const ExperimentSettings& settings,
                        const EvolutionKinds& kinds, const std::stop_token& stop) {
    const auto phenotype = grow(*request.genome, settings, kinds, request.lesions);
    JudgedTrial judged{.result = describe(*phenotype, settings)};
    EvaluationResult& result = judged.result;
    const GoalKind& goal = goal_of(settings, kinds);
    if (!phenotype->can_move() || !phenotype->has_live_control) {
        fail(result, goal, Outcome::kRejected,
             phenotype->can_move() ? "every effector hears only constants" : "no joint can move");
        return judged;
    }
    if (settings.expression.strict_overlap && overlaps_itself(phenotype->plan)) {
        fail(result, goal, Outcome::kRejected, "parts overlap that no joint ties together");
        return judged;
    }
    const auto threshold = goal.may_give_up ? request.threshold : std::nullopt;
    const auto trial = run_terminable_trial(phenotype, kinds.creature, first_trial_world(settings),
                                            {goal, threshold, stop});
    if (!trial) {
        fail(result, goal, Outcome::kRejected, trial.error().message);
        return judged;
    }
    const TrialRecord* record = &trial->record;
    result.computed_time = record->computed_time;
    result.terminable = trial->terminable;
    result.work = record->audit.evaluations;
    result.digest = record->digest;
    result.body_length = record->body_length;
    result.outcome = record->outcome;
    result.reason = record->reason;
    result.audit = record->audit;
    result.verdict = judge(*record);
    if (result.verdict == AuditVerdict::kSuspect) result.work *= kSuspectWork;
    result.behavior = behavior_of(*phenotype, *record);
    Marks marks = marks_of(*record, goal, settings.world.trial);
    result.fitness = marks.score;
    judged.shares = std::move(marks.shares);
    const bool whole = record->outcome == Outcome::kCompleted;
    const bool worth = result.fitness > goal.least_score || !judged.shares.empty();
    if (whole && worth && result.verdict == AuditVerdict::kSuspect)
        settle_suspicion(judged, phenotype, settings, kinds, stop);
    if (!std::isfinite(result.fitness))
        fail(result, goal, Outcome::kDiverged, "the score is not finite");
    return judged;
}

std::shared_ptr<const Phenotype> grow(const Genome& genome, const ExperimentSettings& settings,
                                      const EvolutionKinds& kinds,
                                      std::span<const Lesion> lesions) {
    Phenotype phenotype =
        express(genome, kinds.creature, settings.expression, settings.world.scene);
    inflict(lesions, phenotype);
    return std::make_shared<const Phenotype>(std::move(phenotype));
}

PhenotypeHashes hashes_of(const Genome& genome, const ExperimentSettings& settings,
                          const EvolutionKinds& kinds) {
    const auto phenotype = grow(genome, settings, kinds);
    return {phenotype_hash(*phenotype), body_plan_hash(*phenotype)};
}

FinerResult recompute(const Genome& genome, const ExperimentSettings& settings,
                      const EvolutionKinds& kinds, const std::stop_token& stop) {
    return run_finer(grow(genome, settings, kinds), settings, kinds, stop).result;
}

std::optional<NotedTrial> note_ticks(const Genome& genome, const ExperimentSettings& settings,
                                     const EvolutionKinds& kinds, const std::stop_token& stop) {
    const auto trial =
        Trial::start(grow(genome, settings, kinds), kinds.creature, first_trial_world(settings));
    if (!trial) return std::nullopt;
    NotedTrial noted;
    if (!run_noting_ticks(**trial, noted.ticks, [&] { return stop.stop_requested(); }))
        return std::nullopt;
    noted.digest = (*trial)->record().digest;
    return noted;
}

}  // namespace cambrian
