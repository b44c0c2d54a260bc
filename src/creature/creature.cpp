#include "creature/creature.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr std::size_t kJointEffector = 0;  // the first effector registered drives the joints

}  // namespace

Creature::Creature(const Phenotype& phenotype, const Kinds& kinds, const SceneSettings& settings)
    : phenotype_(&phenotype),
      kinds_(&kinds),
      settings_(&settings),
      brain_(phenotype.network, kinds.functions),
      effector_memory_(phenotype.effector_parts.size(), 0.0) {}

void Creature::reset() {
    brain_.reset();
    std::fill(effector_memory_.begin(), effector_memory_.end(), 0.0);
}

void Creature::act(PhysicsScene& scene, double dt) {
    const std::span<double> readings = brain_.sensors();
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const WiredSensor& sensor = phenotype_->sensors[i];
        const SensorKind& kind = kinds_->sensors[sensor.kind];
        readings[i] =
            sensor.scale * kind.read(scene, sensor.part, sensor.channel, sensor.handedness);
    }
    const int steps = settings_->brain_steps;
    for (int step = 0; step < steps; ++step)
        brain_.think(dt / steps);
    if (dt != tick_) {
        tick_ = dt;
        smoothing_share_ = smoothing_share(dt, settings_->target_smoothing);
    }
    const EffectorKind& effector = kinds_->effectors[kJointEffector];
    for (std::size_t i = 0; i < effector_memory_.size(); ++i) {
        const std::size_t part = phenotype_->effector_parts[i];
        effector.drive({phenotype_->plan.parts[part], part}, brain_.output(i), smoothing_share_,
                       *settings_, effector_memory_[i], scene);
    }
}

void Creature::hold_rest(PhysicsScene& scene) const {
    for (const std::size_t part : phenotype_->effector_parts)
        scene.set_target(part, 0.0);
}

}  // namespace cambrian
