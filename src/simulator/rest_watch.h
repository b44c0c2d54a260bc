#pragma once

// Notices that a creature can never move again, body and brain (simulator/README.md 3), so that
// the rest of its trial need not be computed.

#include "creature/creature.h"
#include "world/physics_scene.h"

#include <cstddef>
#include <vector>

namespace cambrian {

class RestWatch {
public:
    // Phenotype and kinds must outlive it.
    RestWatch(const Phenotype& phenotype, const Kinds& kinds);

    // After every tick: true once for 2 s no part moved faster than 1 mm/s or 0.001 rad/s, no
    // joint's target and no live neuron's memory changed by 1e-6 or more in a tick, and no live
    // oscillator's phase changed at all. Allocates nothing.
    bool watch(const PhysicsScene& scene, const Brain& brain);

private:
    // A value of the brain's memory, and the change from which on it is not at rest.
    struct Remembered {
        std::size_t index = 0;
        double least_change = 0.0;
        double before = 0.0;
    };

    bool targets_rest(const PhysicsScene& scene);
    bool memory_rests(const Brain& brain);

    const Phenotype* phenotype_;
    std::vector<double> targets_;  // one an effector part, at the last tick
    std::vector<Remembered> memory_;
    int calm_ticks_ = 0;
};

}  // namespace cambrian
