#include "evolution/evaluation.h"

#include "creature/overlap.h"
#include "simulator/audit.h"
#include "simulator/trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kFinerTolerance = 0.1;   // of the settings' own
constexpr std::uint64_t kFinerWork = 10;  // times that of a trial whose audit asks for another
constexpr double kSuspectPenalty = 0.5;   // physics.md 9

EvaluationResult describe(const Phenotype& phenotype, const ExperimentSettings& settings) {
    EvaluationResult result;
    result.parts = static_cast<int>(phenotype.parts.size());
    result.neurons = static_cast<int>(phenotype.network.order.size());
    result.mass = phenotype.mass(settings.world.environment.density);
    result.body_length = phenotype.rest_length();
    return result;
}

void fail(EvaluationResult& result, Outcome outcome, std::string reason) {
    result.fitness = 0.0;
    result.outcome = outcome;
    result.reason = std::move(reason);
}

// Shaking scales the score down; see evolution.md 7.7.
double score_of(const TrialRecord& record, const GoalKind& goal, const TrialSettings& trial) {
    if (record.outcome != Outcome::kCompleted && record.outcome != Outcome::kStoppedEarly)
        return 0.0;
    const double score = goal.score(record).value;
    const double shaking = record.reversal_rate / trial.max_reversal_rate;
    return shaking > 1.0 ? score / shaking : score;
}

// A suspect trial is run again more finely; one that stays suspect keeps half its score.
Result<double> score_after_audit(const std::shared_ptr<const Phenotype>& phenotype,
                                 const TrialRecord& record, const GoalKind& goal,
                                 const ExperimentSettings& settings, const Kinds& kinds) {
    const double score = score_of(record, goal, settings.world.trial);
    if (score <= 0.0 || judge(record.audit) == AuditVerdict::kClean) return score;
    TrialWorld finer = settings.world;
    finer.scene.tolerance *= kFinerTolerance;
    const auto again = run_trial(phenotype, kinds, finer);
    if (!again) return again.error();
    const double finer_score = score_of(*again, goal, settings.world.trial);
    return judge(again->audit) == AuditVerdict::kClean ? finer_score
                                                       : kSuspectPenalty * finer_score;
}

}  // namespace

EvaluationResult evaluate(const EvaluationRequest& request, const ExperimentSettings& settings,
                          const EvolutionKinds& kinds) {
    const auto phenotype = std::make_shared<const Phenotype>(
        express(*request.genome, kinds.creature, settings.expression, settings.world.scene));
    EvaluationResult result = describe(*phenotype, settings);
    if (!phenotype->can_move() || !phenotype->has_live_control) {
        fail(result, Outcome::kRejected,
             phenotype->can_move() ? "every effector hears only constants" : "no joint can move");
        return result;
    }
    if (settings.expression.strict_overlap && overlaps_itself(phenotype->plan)) {
        fail(result, Outcome::kRejected, "parts overlap that no joint ties together");
        return result;
    }
    const GoalKind* goal = kinds.goals.find(settings.goal);
    CAMBRIAN_ASSERT(goal != nullptr, "settings were checked");
    const auto trial =
        run_barred_trial(phenotype, kinds.creature, settings.world, *goal, request.bar);
    if (!trial) {
        fail(result, Outcome::kRejected, trial.error().message);
        return result;
    }
    const TrialRecord* record = &trial->record;
    result.computed_time = record->computed_time;
    result.hopeless = trial->hopeless;
    result.work = record->audit.evaluations;
    if (judge(record->audit) == AuditVerdict::kSuspect) result.work *= kFinerWork;
    result.digest = record->digest;
    result.body_length = record->body_length;
    result.outcome = record->outcome;
    result.reason = record->reason;
    result.behavior = behavior_of(*phenotype, *record);
    const auto score = score_after_audit(phenotype, *record, *goal, settings, kinds.creature);
    if (!score || !std::isfinite(*score)) {
        fail(result, Outcome::kDiverged, score ? "the score is not finite" : score.error().message);
        return result;
    }
    result.fitness = *score;
    return result;
}

}  // namespace cambrian
