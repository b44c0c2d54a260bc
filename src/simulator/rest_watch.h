#pragma once

// Detects that body and brain of a creature can never move again (simulator/README.md 3), so that
// the rest of its trial need not be computed.

#include "creature/creature.h"
#include "world/physics_scene.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

class RestWatch {
public:
    RestWatch(const Network& network, const NeuronFunctionRegistry& functions);

    // Must be called after every tick. Returns true once the creature has been at rest for 2 s: no
    // part moved faster than 1 mm/s or 0.001 rad/s, no motor's target and no connected neuron's
    // memory changed by 1e-6 or more in a tick, and no connected oscillator's phase changed at all.
    // Allocates nothing.
    bool watch(const PhysicsScene& scene, const Brain& brain);

private:
    // A value of the brain's memory, and the least change that counts.
    struct Remembered {
        std::size_t index = 0;
        double least_change = 0.0;
    };

    bool memory_rests(std::span<const double> memory) const;

    std::vector<Remembered> remembered_;
    std::vector<double> before_;  // the brain's memory at the last tick
    int calm_ticks_ = 0;
};

}  // namespace cambrian
