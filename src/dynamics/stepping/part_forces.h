#pragma once

// What acts on each part, as means over a tick: for sensors.

#include "dynamics/contact/contact.h"

namespace cambrian {

struct PartForces {
    // m/s^2; acceleration of the part's centre less gravity. While a tick goes on, the centre's
    // velocity at its start.
    PerPart specific_x = {}, specific_y = {};
    PerPart load = {};  // N, sum of the normal forces; N s so far while a tick goes on
};

// The kinematics are those of the tick's start.
void begin_forces(const PlanarModel& model, const Kinematics& kinematics, PartForces& forces);

// Adds the normal impulse (N s) of a contact to the parts that touch.
void add_load(const Contact& contact, double impulse, PartForces& forces);

// The kinematics are those of the end of the tick, which lasted `duration` (s).
void end_forces(const PlanarModel& model, const Medium& medium, const Kinematics& kinematics,
                double duration, PartForces& forces);

}  // namespace cambrian
