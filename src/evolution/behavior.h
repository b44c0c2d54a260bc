#pragma once

// What a creature is like rather than how good it is: the measures that keep kinds of creatures
// apart (evolution.md 6.2).

#include "creature/phenotype.h"
#include "simulator/trial_record.h"

namespace cambrian {

struct Behavior {
    double settled_height = 0.0;   // m, once at rest at the start of the test
    double contact_share = 0.0;    // of the test, in which it touched the ground; 0 to 1
    double joint_frequency = 0.0;  // Hz, of the busiest joint
    int movable_joints = 0;

    friend bool operator==(const Behavior&, const Behavior&) = default;
};

Behavior behavior_of(const Phenotype& phenotype, const TrialRecord& record);

}  // namespace cambrian
