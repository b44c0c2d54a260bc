#pragma once

// Forces on the measured parts of a model, as means over a tick, for sensors.

#include "dynamics/contact/contact.h"
#include "dynamics/model/kinematics.h"

namespace cambrian {

struct PartForces {
    PerPart speed_x = {}, speed_y = {};        // m/s, of the part's centre at the end of the tick
    PerPart specific_x = {}, specific_y = {};  // m/s^2, acceleration of the centre minus gravity
    PerPart load = {};  // N, sum of the normal forces; during a tick, the impulse in N s so far
};

// Notes the speeds at the start of a motion, of which the kinematics are given.
void note_speeds(const PlanarModel& model, const Kinematics& kinematics, PartForces& forces);

void begin_forces(const PlanarModel& model, PartForces& forces);

// Adds the normal impulse (N s) of a contact to the parts that touch.
void add_load(const PlanarModel& model, const Contact& contact, double impulse, PartForces& forces);

// The kinematics must be those of the end of the tick, which lasted `duration` (s).
void end_forces(const PlanarModel& model, const Medium& medium, const Kinematics& kinematics,
                double duration, PartForces& forces);

}  // namespace cambrian
