#include "pictures/motion/subject.h"

#include "core/text/code_points.h"
#include "core/text/pretty_text.h"
#include "core/text/shown_score.h"
#include "evolution/evaluation/trials.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace cambrian {
namespace {

// Returns whether the document's score was made with these settings.
bool of_the_score(const CreatureDocument& document, const ExperimentSettings& settings) {
    return document.scored() && same_judgement(document.settings(), settings);
}

std::string fitness_of(const CreatureDocument& document, const ExperimentSettings& settings,
                       const TrialRecord& record, const GoalKind& goal) {
    if (of_the_score(document, settings)) return shown_score(document.score(), document.notes.unit);
    if (record.outcome != Outcome::kCompleted) return std::string(outcome_name(record.outcome));
    return shown_score(goal.score(record).value, goal.unit);
}

}  // namespace

std::vector<CountedMuscles> muscles_of(const Phenotype& phenotype) {
    std::vector<CountedMuscles> muscles;
    const std::size_t deformers = phenotype.deformers();
    const auto joints = static_cast<std::size_t>(
        std::count_if(phenotype.effectors.begin(), phenotype.effectors.end(),
                      [](const JointDegree& effector) { return effector.degree == 0; }));
    if (joints > 0 || deformers == 0) muscles.push_back({joints, "moving joint"});
    if (deformers > 0) muscles.push_back({deformers, "deforming part"});
    return muscles;
}

Result<Subject> subject_of(const CreatureDocument& document, const ExperimentSettings& settings,
                           const std::string& title, const EvolutionKinds& kinds,
                           const TrialWatch& watch, int number) {
    TrialSetup setup = trial_setup(document.creature.individual->genome, settings, number);
    auto phenotype = std::make_shared<const Phenotype>(
        express(*setup.genome, kinds.creature, settings.expression, settings.world.scene));
    auto trial = record_trial(phenotype, kinds.creature, setup.world, watch);
    if (!trial) return trial.error();
    Subject subject;
    subject.world = std::move(setup.world);
    subject.creature = document.creature;
    subject.creature.settings = std::make_shared<const ExperimentSettings>(settings);
    subject.name = on_one_line(document.genome().name.empty() ? title : document.genome().name);
    subject.mass = trial->record.mass;
    if (const GoalKind* goal = kinds.goals.find(settings.goal)) {
        subject.goal = goal->label;
        subject.fitness = fitness_of(document, settings, trial->record, *goal);
    }
    if (of_the_score(document, settings) && settings.world.trial.trials == 1)
        subject.verified = document.result().digest == trial->record.digest;
    subject.trial = std::move(*trial);
    return subject;
}

}  // namespace cambrian
