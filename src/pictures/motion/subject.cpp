#include "pictures/motion/subject.h"

#include "core/text/pretty_text.h"

#include <memory>
#include <utility>

namespace cambrian {
namespace {

// Returns whether the document's score was made with these settings.
bool of_the_score(const CreatureDocument& document, const ExperimentSettings& settings) {
    if (!document.scored) return false;
    const ScoredRecord& scored = *document.scored;
    return scored.world == settings.world && scored.expression == settings.expression &&
           scored.goal == settings.goal;
}

std::string fitness_of(const CreatureDocument& document, const ExperimentSettings& settings,
                       const TrialRecord& record, const GoalKind& goal) {
    if (of_the_score(document, settings))
        return measured(document.scored->fitness, document.scored->unit);
    if (record.outcome != Outcome::kCompleted) return std::string(outcome_name(record.outcome));
    return measured(goal.score(record).value, goal.unit);
}

}  // namespace

Result<Subject> subject_of(const CreatureDocument& document, const ExperimentSettings& settings,
                           const std::string& title, const EvolutionKinds& kinds,
                           const TrialWatch& watch) {
    auto phenotype = std::make_shared<const Phenotype>(
        express(document.genome, kinds.creature, settings.expression, settings.world.scene));
    auto trial = record_trial(phenotype, kinds.creature, settings.world, watch);
    if (!trial) return trial.error();
    Subject subject;
    subject.name = document.genome.name.empty() ? title : document.genome.name;
    subject.hue = document.genome.hue;
    subject.environment = settings.world.environment;
    subject.mass = trial->record.mass;
    if (const GoalKind* goal = kinds.goals.find(settings.goal)) {
        subject.goal = goal->label;
        subject.fitness = fitness_of(document, settings, trial->record, *goal);
    }
    if (of_the_score(document, settings) && settings.world.trial.trials == 1)
        subject.verified = document.scored->trajectory == trial->record.digest;
    subject.trial = std::move(*trial);
    return subject;
}

}  // namespace cambrian
