#include "creature/creature.h"

#include "core/assert.h"

#include <algorithm>

namespace cambrian {
Creature::Creature(const Phenotype& phenotype, const Kinds& kinds, const SceneSettings& settings)
    : phenotype_(&phenotype),
      settings_(&settings),
      brain_(phenotype.network, kinds.functions),
      sensor_memory_(phenotype.sensors.size(), 0.0),
      effector_memory_(phenotype.effector_parts.size(), 0.0) {
    readers_.reserve(phenotype.sensors.size());
    for (const WiredSensor& sensor : phenotype.sensors)
        readers_.push_back(
            {kinds.sensors[sensor.kind].read, kinds.sensors[sensor.kind].time_constant});
    drives_.reserve(phenotype.effector_kinds.size());
    for (const std::uint8_t kind : phenotype.effector_kinds)
        drives_.push_back(kinds.effectors[kind].drive);
}

void Creature::reset() {
    brain_.reset();
    std::fill(sensor_memory_.begin(), sensor_memory_.end(), 0.0);
    std::fill(effector_memory_.begin(), effector_memory_.end(), 0.0);
}

SensorSite Creature::site_of(const WiredSensor& sensor, const BodyView& body,
                             const Surroundings& surroundings, double share) const {
    return {body,        surroundings,   phenotype_->plan.parts[sensor.part],
            sensor.part, sensor.channel, sensor.handedness,
            share};
}

// Computes what depends only on a tick's length.
void Creature::use_tick(double dt) {
    if (dt == tick_) return;
    tick_ = dt;
    smoothing_share_ = smoothing_share(dt, settings_->target_smoothing);
    for (Reader& reader : readers_)
        reader.share = smoothing_share(dt, reader.time_constant);
}

void Creature::sense(const BodyView& body, const Surroundings& surroundings) {
    const std::span<double> readings = brain_.sensors();
    for (std::size_t i = 0; i < readings.size(); ++i) {
        const WiredSensor& sensor = phenotype_->sensors[i];
        readings[i] =
            sensor.scale * readers_[i].read(site_of(sensor, body, surroundings, readers_[i].share),
                                            sensor_memory_[i]);
    }
}

double Creature::reading(std::size_t sensor, const BodyView& body,
                         const Surroundings& surroundings) const {
    double memory = sensor_memory_[sensor];
    return readers_[sensor].read(site_of(phenotype_->sensors[sensor], body, surroundings, 0.0),
                                 memory);
}

void Creature::act(PhysicsScene& scene, const Surroundings& surroundings, double dt) {
    use_tick(dt);
    sense(scene, surroundings);
    CAMBRIAN_TICK_ASSERT(settings_->brain_steps > 0 && dt > 0.0, "a brain thinks");
    const int steps = settings_->brain_steps;
    for (int step = 0; step < steps; ++step)
        brain_.think(dt / steps);
    for (std::size_t i = 0; i < effector_memory_.size(); ++i) {
        const std::size_t part = phenotype_->effector_parts[i];
        drives_[i]({phenotype_->plan.parts[part], part}, brain_.output(i), smoothing_share_,
                   *settings_, effector_memory_[i], scene);
    }
}

void Creature::hold_rest(PhysicsScene& scene) const {
    for (const std::size_t part : phenotype_->effector_parts)
        scene.set_target(part, 0.0);
}

}  // namespace cambrian
