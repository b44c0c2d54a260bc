#include "simulator/rest_watch.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr int kRestTicks = 120;           // 2 s
constexpr double kSlowestMotion = 0.001;  // m/s
constexpr double kSlowestSpin = 0.001;    // rad/s
constexpr double kLeastChange = 1e-6;     // per tick, of targets and memory

bool body_rests(const PhysicsScene& scene) {
    for (std::size_t part = 0; part < scene.part_count(); ++part) {
        const Twist twist = scene.part_twist(part);
        if (twist.linear.norm() > kSlowestMotion || twist.angular.norm() > kSlowestSpin)
            return false;
    }
    return true;
}

// Updates `before`; returns whether it changed by less than `least`.
bool unchanged(double& before, double now, double least) {
    const double change = std::fabs(now - before);
    before = now;
    return change < least || change == 0.0;
}

}  // namespace

RestWatch::RestWatch(const Phenotype& phenotype, const Kinds& kinds)
    : phenotype_(&phenotype), targets_(phenotype.effector_parts.size(), 0.0) {
    for (const std::uint32_t live : phenotype.network.order) {
        const NetworkNeuron& neuron = phenotype.network.neurons[live];
        const NeuronFunctionKind& function = kinds.functions[neuron.function];
        for (int i = 0; i < function.memory_size; ++i) {
            memory_.push_back({.index = neuron.memory + static_cast<std::size_t>(i),
                               .least_change = function.oscillates ? 0.0 : kLeastChange});
        }
    }
}

bool RestWatch::targets_rest(const PhysicsScene& scene) {
    bool rest = true;
    for (std::size_t i = 0; i < targets_.size(); ++i) {
        const double target = scene.target(phenotype_->effector_parts[i]);
        rest = unchanged(targets_[i], target, kLeastChange) && rest;
    }
    return rest;
}

bool RestWatch::memory_rests(const Brain& brain) {
    bool rest = true;
    for (Remembered& value : memory_)
        rest = unchanged(value.before, brain.memory()[value.index], value.least_change) && rest;
    return rest;
}

bool RestWatch::watch(const PhysicsScene& scene, const Brain& brain) {
    const bool targets = targets_rest(scene);
    const bool memory = memory_rests(brain);
    calm_ticks_ = targets && memory && body_rests(scene) ? calm_ticks_ + 1 : 0;
    return calm_ticks_ >= kRestTicks;
}

}  // namespace cambrian
