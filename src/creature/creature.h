#pragma once

// A phenotype with its present state (brain, sensors, effectors), acting on a scene. It has one
// owner and is used by one thread.

#include "brain/brain.h"
#include "creature/phenotype.h"
#include "world/physics_scene.h"

#include <vector>

namespace cambrian {

class Creature {
public:
    // The phenotype, kinds and settings must outlive the creature.
    Creature(const Phenotype& phenotype, const Kinds& kinds, const SceneSettings& settings);

    // Restores the initial state: clears the memory of sensors, brain and effectors.
    void reset();
    // Advances control by one tick: reads sensors, evaluates the brain, sets the joints' targets.
    // Allocates nothing.
    // The sounds and scents of its organs are in emissions() until the next call.
    void act(PhysicsScene& scene, const Surroundings& surroundings, double dt);
    // Sets the target of every joint and deformable part to rest, without evaluating the brain.
    void hold_rest(PhysicsScene& scene) const;

    const Phenotype& phenotype() const { return *phenotype_; }
    const Brain& brain() const { return brain_; }
    Brain& brain() { return brain_; }
    const Emissions& emissions() const { return emissions_; }
    // Returns the present reading of a wired sensor in its own unit; no time passes.
    double reading(std::size_t sensor, const BodyView& body,
                   const Surroundings& surroundings) const;

    // All state that changes during a trial, for going back in a replay.
    struct State {
        Brain brain;
        std::vector<double> sensor_memory;
        std::vector<double> effector_memory;
        std::vector<double> organ_memory;
    };
    State save() const { return {brain_, sensor_memory_, effector_memory_, organ_memory_}; }
    void restore(const State& state) {
        brain_ = state.brain;
        sensor_memory_ = state.sensor_memory;
        effector_memory_ = state.effector_memory;
        organ_memory_ = state.organ_memory;
    }

private:
    // A wired sensor in the scene of the last tick.
    struct Reader {
        SensorKind::Read read = nullptr;
        double scale = 1.0;
        SensorSite site;
    };
    // An effector and its part.
    struct Driver {
        EffectorKind::Drive drive = nullptr;
        EffectorSite site;
    };

    void prepare(const BodyView& body, const Surroundings& surroundings, double dt);
    void remember_held();
    void sense();
    void drive(PhysicsScene& scene);
    void use_organs(PhysicsScene& scene, double dt);
    SensorSite site_of(const WiredSensor& sensor, const BodyView& body,
                       const Surroundings& surroundings, double share) const;

    const Phenotype* phenotype_;
    const Kinds* kinds_;
    const SceneSettings* settings_;
    // These are of the last tick.
    const BodyView* body_ = nullptr;
    const Surroundings* surroundings_ = nullptr;
    double tick_ = 0.0;             // s; its length
    double smoothing_share_ = 0.0;  // share of the smoothing done in a tick of that length
    Brain brain_;
    std::vector<Reader> readers_;                // one per wired sensor; built in the first tick
    std::vector<double> sensor_memory_;          // one per wired sensor
    std::vector<Driver> drivers_;                // one per effector
    std::vector<double> effector_memory_;        // one per effector
    std::vector<OrganKind::Act> organ_acts_;     // one per organ
    std::vector<std::size_t> parameter_counts_;  // one per organ
    std::vector<double> organ_memory_;           // one per organ
    Emissions emissions_;                        // of the last tick
};

}  // namespace cambrian
