#pragma once

// Detects that body and brain of a creature can never move again (simulator/README.md 3), so that
// the rest of its trial need not be computed.

#include "creature/creature.h"
#include "world/physics_scene.h"

#include <cstddef>
#include <vector>

namespace cambrian {

class RestWatch {
public:
    // `phenotype` and `kinds` must outlive the object.
    RestWatch(const Phenotype& phenotype, const Kinds& kinds);

    // Must be called after every tick. Returns true once the creature has been at rest for 2 s: no
    // part moved faster than 1 mm/s or 0.001 rad/s, no joint's target and no connected neuron's
    // memory changed by 1e-6 or more in a tick, and no connected oscillator's phase changed at all.
    // Allocates nothing.
    bool watch(const PhysicsScene& scene, const Brain& brain);

private:
    // A value of the brain's memory, and the least change that counts.
    struct Remembered {
        std::size_t index = 0;
        double least_change = 0.0;
        double before = 0.0;
    };

    bool targets_rest(const PhysicsScene& scene);
    bool memory_rests(const Brain& brain);

    const Phenotype* phenotype_;
    std::vector<double> targets_;  // one per effector part, at the last tick
    std::vector<Remembered> memory_;
    int calm_ticks_ = 0;
};

}  // namespace cambrian
