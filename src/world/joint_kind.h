#pragma once

// A registered joint: the motion it allows, and what a gene's numbers become on an expressed part.

#include "core/registry.h"
#include "world/body_plan.h"

#include <string>

namespace cambrian {

// What the limits and the motor's cap of an expressed joint depend on.
struct JointGenes {
    double limit_low = 0.0;   // of the gene: rad, or lengths of the part where the joint slides
    double limit_high = 0.0;  // the same
    double length = 0.0;      // m, of the part
    double width = 0.0;       // m, of the narrower one of the two parts
    int handedness = 1;       // -1 on mirrored parts
    double muscle_strength = 0.0;  // SceneSettings::muscle_strength
};

struct JointKind {
    std::string id;     // written to files: "rigid", "rotary", "linear"
    std::string label;  // shown
    JointMotion motion = JointMotion::kFixed;
    bool usual = true;  // whether founders and mutations use it unless settings say otherwise
    // Sets limits and the motor's cap; needed unless the joint is fixed.
    void (*shape)(const JointGenes& genes, PlannedPart& part) = nullptr;

    int degrees_of_freedom() const { return motion == JointMotion::kFixed ? 0 : 1; }
};

using JointRegistry = Registry<JointKind>;

}  // namespace cambrian
