#include "bench/evaluation_cost.h"

#include "core/thread_time.h"
#include "simulator/trial.h"

#include <vector>

namespace cambrian::bench {
namespace {

constexpr double kClearance = 0.02;  // m

// Returns the motor targets of a trial, tick after tick, one per effector part.
std::vector<double> recorded_targets(const std::shared_ptr<const Phenotype>& phenotype,
                                     const Kinds& kinds, const TrialWorld& world) {
    std::vector<double> targets;
    auto trial = Trial::start(phenotype, kinds, world);
    for (bool more = trial.has_value(); more;) {
        more = (*trial)->tick();
        for (const JointDegree& joint : phenotype->effectors)
            targets.push_back((*trial)->scene().target(joint));
    }
    return targets;
}

// Moves the same body with the same targets and does nothing else.
void move(const Phenotype& phenotype, const Kinds& kinds, const TrialWorld& world,
          const std::vector<double>& targets) {
    const auto scene = kinds.scene.make(phenotype.plan, world.environment, world.scene);
    if (!scene) return;
    // Places the body on the ground, as a trial does.
    if (world.environment.has_ground)
        (*scene)->translate(Vec3(0.0, kClearance - (*scene)->bounds().low.y(), 0.0));
    for (auto target = targets.begin(); target != targets.end();) {
        for (const JointDegree& joint : phenotype.effectors)
            (*scene)->set_target(joint, *target++);
        (*scene)->advance(kBrainTick);
    }
}

}  // namespace

EvaluationCost& EvaluationCost::operator+=(const EvaluationCost& other) {
    expression += other.expression;
    trial += other.trial;
    physics += other.physics;
    scoring += other.scoring;
    return *this;
}

EvaluationCost measure_cost(const Genome& genome, const ExperimentSettings& settings,
                            const EvolutionKinds& kinds) {
    EvaluationCost cost;
    ThreadTimer timer;
    const auto phenotype = std::make_shared<const Phenotype>(
        express(genome, kinds.creature, settings.expression, settings.world.scene));
    cost.expression = timer.lap();
    const auto targets = recorded_targets(phenotype, kinds.creature, settings.world);
    timer.lap();
    const auto record = run_trial(phenotype, kinds.creature, settings.world);
    cost.trial = timer.lap();
    if (record) kinds.goals.find(settings.goal)->score(*record);
    cost.scoring = timer.lap();
    move(*phenotype, kinds.creature, settings.world, targets);
    cost.physics = timer.lap();
    return cost;
}

}  // namespace cambrian::bench
