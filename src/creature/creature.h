#pragma once

// A living phenotype: its brain and effectors' memory, acting on a scene. One owner, one thread.

#include "brain/brain.h"
#include "creature/phenotype.h"
#include "world/physics_scene.h"

#include <vector>

namespace cambrian {

class Creature {
public:
    // The phenotype, kinds and settings must outlive the creature.
    Creature(const Phenotype& phenotype, const Kinds& kinds, const SceneSettings& settings);

    // As at birth: sensors, brain and effectors forget.
    void reset();
    // One tick of control: read sensors, think, drive the joints' targets. Allocates nothing.
    void act(PhysicsScene& scene, const Surroundings& surroundings, double dt);
    // All joints told to keep their rest coordinate; the brain stays off.
    void hold_rest(PhysicsScene& scene) const;

    const Phenotype& phenotype() const { return *phenotype_; }
    const Brain& brain() const { return brain_; }
    Brain& brain() { return brain_; }
    // What a wired sensor reads at this moment, in its own unit, without time passing.
    double reading(std::size_t sensor, const BodyView& body,
                   const Surroundings& surroundings) const;

    // Everything that changes while it lives, for stepping back in a replay.
    struct State {
        Brain brain;
        std::vector<double> sensor_memory;
        std::vector<double> effector_memory;
    };
    State save() const { return {brain_, sensor_memory_, effector_memory_}; }
    void restore(const State& state) {
        brain_ = state.brain;
        sensor_memory_ = state.sensor_memory;
        effector_memory_ = state.effector_memory;
    }

private:
    void sense(const BodyView& body, const Surroundings& surroundings, double dt);
    SensorSite site_of(const WiredSensor& sensor, const BodyView& body,
                       const Surroundings& surroundings, double dt) const;

    const Phenotype* phenotype_;
    const SceneSettings* settings_;
    double tick_ = 0.0;             // s; the last one acted in
    double smoothing_share_ = 0.0;  // of that
    Brain brain_;
    std::vector<SensorKind::Read> sensor_reads_;  // one a wired sensor
    std::vector<double> sensor_memory_;           // the same
    std::vector<EffectorKind::Drive> drives_;     // one an effector part
    std::vector<double> effector_memory_;         // the same
};

}  // namespace cambrian
