#pragma once

// The energy balance of a trial over time, recorded during playback (simulator/README.md 4).

#include "world/physics_scene.h"

#include <vector>

namespace cambrian {

// Energies since the start of the test, in J. `muscles` is the sum of all others.
struct EnergySample {
    double time = 0.0;      // s
    double muscles = 0.0;   // net work of the muscles
    double stored = 0.0;    // change of kinetic and potential energy
    double drag = 0.0;      // lost to the medium
    double contacts = 0.0;  // lost to friction, impacts and joint limits
    double unexplained = 0.0;
};

EnergySample energy_sample(double time, const SceneAudit& audit);

class EnergyTrace {
public:
    void clear() { samples_.clear(); }
    // Stores a reading every tenth of a second. A time before the last one removes the readings
    // after it.
    void add(double time, const SceneAudit& audit);
    const std::vector<EnergySample>& samples() const { return samples_; }

private:
    std::vector<EnergySample> samples_;
};

}  // namespace cambrian
