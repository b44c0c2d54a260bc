#include "creature/creature.h"

#include "core/assert.h"

#include <algorithm>

namespace cambrian {
namespace {

// The reading of a held sensor: its memory, which begins with it.
double read_memory(const SensorSite& /*site*/, double& memory) {
    return memory;
}

}  // namespace

Creature::Creature(const Phenotype& phenotype, const Kinds& kinds, const SceneSettings& settings)
    : phenotype_(&phenotype),
      kinds_(&kinds),
      settings_(&settings),
      brain_(phenotype.network, kinds.functions),
      sensor_memory_(phenotype.sensors.size(), 0.0),
      effector_memory_(phenotype.effectors.size(), 0.0),
      organ_memory_(phenotype.organs.size(), 0.0) {
    remember_held();
    readers_.reserve(phenotype.sensors.size());
    drivers_.reserve(phenotype.effectors.size());
    for (std::size_t i = 0; i < phenotype.effectors.size(); ++i) {
        const JointDegree& effector = phenotype.effectors[i];
        drivers_.push_back({kinds.effectors[phenotype.effector_kinds[i]].drive,
                            {phenotype.plan.parts[effector.part], effector}});
    }
    organ_acts_.reserve(phenotype.organs.size());
    parameter_counts_.reserve(phenotype.organs.size());
    std::size_t sounds = 0, scents = 0;
    for (const GrownOrgan& organ : phenotype.organs) {
        const OrganKind& kind = kinds.organs[organ.kind];
        organ_acts_.push_back(kind.act);
        parameter_counts_.push_back(kind.parameters.size());
        sounds += kind.sounds ? 1 : 0;
        scents += kind.scents ? 1 : 0;
    }
    emissions_.sounds.reserve(sounds);
    emissions_.scents.reserve(scents);
}

void Creature::remember_held() {
    for (std::size_t i = 0; i < sensor_memory_.size(); ++i)
        sensor_memory_[i] = phenotype_->sensors[i].held.value_or(0.0);
}

void Creature::reset() {
    brain_.reset();
    remember_held();
    std::fill(effector_memory_.begin(), effector_memory_.end(), 0.0);
    std::fill(organ_memory_.begin(), organ_memory_.end(), 0.0);
    emissions_.clear();
}

SensorSite Creature::site_of(const WiredSensor& sensor, const BodyView& body,
                             const Surroundings& surroundings, double share) const {
    return {body,        surroundings,   phenotype_->plan.parts[sensor.part],
            sensor.part, sensor.channel, sensor.mirror,
            share};
}

// Computes what is the same in every tick of the same scene and length.
void Creature::prepare(const BodyView& body, const Surroundings& surroundings, double dt) {
    tick_ = dt;
    body_ = &body;
    surroundings_ = &surroundings;
    smoothing_share_ = smoothing_share(dt, settings_->target_smoothing);
    readers_.clear();
    for (const WiredSensor& sensor : phenotype_->sensors) {
        const SensorKind& kind = kinds_->sensors[sensor.kind];
        const double share = smoothing_share(dt, kind.time_constant);
        readers_.push_back({sensor.held ? read_memory : kind.read, sensor.scale,
                            site_of(sensor, body, surroundings, share)});
    }
}

void Creature::sense() {
    CAMBRIAN_TICK_ASSERT(readers_.size() == brain_.sensors().size(), "a reading of each sensor");
    double* reading = brain_.sensors().data();
    double* memory = sensor_memory_.data();
    for (const Reader& reader : readers_)
        *reading++ = reader.scale * reader.read(reader.site, *memory++);
}

double Creature::reading(std::size_t sensor, const BodyView& body,
                         const Surroundings& surroundings) const {
    double memory = sensor_memory_[sensor];
    const WiredSensor& wired = phenotype_->sensors[sensor];
    return kinds_->sensors[wired.kind].read(site_of(wired, body, surroundings, 0.0), memory);
}

void Creature::act(PhysicsScene& scene, const Surroundings& surroundings, double dt) {
    if (dt != tick_ || &scene != body_ || &surroundings != surroundings_)
        prepare(scene, surroundings, dt);
    sense();
    CAMBRIAN_TICK_ASSERT(settings_->brain_steps > 0 && dt > 0.0, "a brain thinks");
    const int steps = settings_->brain_steps;
    for (int step = 0; step < steps; ++step)
        brain_.think(dt / steps);
    drive(scene);
    if (!organ_acts_.empty()) use_organs(scene, dt);
}

void Creature::drive(PhysicsScene& scene) {
    std::size_t output = 0;
    double* memory = effector_memory_.data();
    for (const Driver& driver : drivers_)
        driver.drive(driver.site, brain_.output(output++), smoothing_share_, *settings_, *memory++,
                     scene);
}

void Creature::use_organs(PhysicsScene& scene, double dt) {
    emissions_.clear();
    for (std::size_t i = 0; i < organ_acts_.size(); ++i) {
        const GrownOrgan& organ = phenotype_->organs[i];
        organ_acts_[i]({.scene = scene,
                        .part = phenotype_->plan.parts[organ.part],
                        .index = organ.part,
                        .parameters = {organ.parameters.data(), parameter_counts_[i]},
                        .dt = dt,
                        .smoothing_share = smoothing_share_,
                        .memory = organ_memory_[i]},
                       brain_.output(effector_memory_.size() + i), emissions_);
    }
}

void Creature::hold_rest(PhysicsScene& scene) const {
    for (const JointDegree& effector : phenotype_->effectors)
        scene.set_target(effector, 0.0);
    for (const GrownOrgan& organ : phenotype_->organs)
        scene.set_stretch_target(organ.part, 0.0);
}

}  // namespace cambrian
