#pragma once

// A registered kind of joint: its motion, and how a gene's numbers set limits and motor of a part.

#include "core/registry.h"
#include "world/body_plan.h"

#include <string>

namespace cambrian {

// The data on which limits and motor of an expressed joint depend.
struct JointGenes {
    // Limit of the gene, in rad, or in lengths of the part for a sliding joint.
    double limit_low = 0.0;
    double limit_high = 0.0;       // as limit_low
    double length = 0.0;           // m, of the part
    double width = 0.0;            // m, of the narrower one of the two parts
    int handedness = 1;            // -1 for mirrored parts
    double muscle_strength = 0.0;  // SceneSettings::muscle_strength
};

struct JointKind {
    std::string id;     // written to files: "rigid", "rotary", "linear"
    std::string label;  // displayed name
    JointMotion motion = JointMotion::kFixed;
    bool usual = true;  // enabled in founders and mutations by default
    // Sets the limits and the motor's largest effort; required unless the joint is fixed.
    void (*shape)(const JointGenes& genes, PlannedPart& part) = nullptr;

    int degrees_of_freedom() const { return motion == JointMotion::kFixed ? 0 : 1; }
};

using JointRegistry = Registry<JointKind>;

}  // namespace cambrian
