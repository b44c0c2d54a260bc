#pragma once

// What a creature is like rather than how good it is: the measures that keep kinds of creatures
// apart (evolution/README.md 2).

#include "creature/phenotype.h"
#include "simulator/trial_record.h"

namespace cambrian {

struct Behavior {
    double settled_height = 0.0;        // m, once at rest at the start of the test
    double contact_share = 0.0;         // of the test, in which it touched the ground; 0 to 1
    double joint_frequency = 0.0;       // Hz, of the busiest joint
    double mean_joint_frequency = 0.0;  // Hz, of all joints that can move
    double travel = 0.0;                // m, of the centre of mass from start to end of the test
    // m, the furthest that the centre of mass or a side of the bounding box ever was from where it
    // started: 0 for a creature that rested all the time.
    double stir = 0.0;
    int movable_joints = 0;

    friend bool operator==(const Behavior&, const Behavior&) = default;
};

Behavior behavior_of(const Phenotype& phenotype, const TrialRecord& record);

}  // namespace cambrian
