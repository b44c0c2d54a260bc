#pragma once

// Forces on the measured parts of a model, as means over a tick, for sensors.

#include "dynamics/contact/contact.h"

namespace cambrian {

struct PartForces {
    // Acceleration of the part's centre minus gravity, in m/s^2. During a tick, it is the centre's
    // velocity at the tick's start.
    PerPart specific_x = {}, specific_y = {};
    PerPart load = {};  // N, sum of the normal forces; during a tick, the impulse in N s so far
};

// The kinematics must be those of the tick's start.
void begin_forces(const PlanarModel& model, const Kinematics& kinematics, PartForces& forces);

// Adds the normal impulse (N s) of a contact to the parts that touch.
void add_load(const PlanarModel& model, const Contact& contact, double impulse, PartForces& forces);

// The kinematics must be those of the end of the tick, which lasted `duration` (s).
void end_forces(const PlanarModel& model, const Medium& medium, const Kinematics& kinematics,
                double duration, PartForces& forces);

}  // namespace cambrian
