#pragma once

// Measures of what a creature is like rather than how fit it is. Methods that preserve diversity
// use them (evolution/README.md 2).

#include "creature/phenotype.h"
#include "simulator/trial_record.h"

namespace cambrian {

struct Behavior {
    double settled_height = 0.0;   // m, at rest at the start of the test
    double contact_share = 0.0;    // share of the test in which it touched the ground, in [0, 1]
    double joint_frequency = 0.0;  // Hz, of the joint with the highest frequency
    double mean_joint_frequency = 0.0;  // Hz, mean of all joints that can move
    double travel = 0.0;  // m, from the centre of mass at the start of the test to that at its end
    // The greatest distance, in m, of the centre of mass or a side of the bounding box from its
    // start. It is 0 for a creature that never moved.
    double stir = 0.0;
    int movable_joints = 0;

    friend bool operator==(const Behavior&, const Behavior&) = default;
};

Behavior behavior_of(const Phenotype& phenotype, const TrialRecord& record);

}  // namespace cambrian
