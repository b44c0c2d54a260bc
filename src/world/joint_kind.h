#pragma once

// A registered kind of joint: its motion, and how a gene's numbers set limits and motor of a part.

#include "core/registry.h"
#include "world/body_plan.h"

#include <array>
#include <string>

namespace cambrian {

// The signs of a part's sides y and z, which mirroring flips (creature/README.md 2).
struct Mirror {
    int across = 1;  // handedness: left and right
    int depth = 1;   // front and back; 1 in the plane

    // Returns the sign of the part's angle about an axis of its frame (x, y, z): turns are
    // pseudovectors.
    int of_turn(int axis) const {
        if (axis == 0) return across * depth;
        return axis == 1 ? depth : across;
    }

    friend bool operator==(const Mirror&, const Mirror&) = default;
};

// The data on which limits and motor of an expressed joint depend.
struct JointGenes {
    // Limit of the gene, in rad, or in lengths of the part for a sliding joint.
    double limit_low = 0.0;
    double limit_high = 0.0;  // as limit_low
    double length = 0.0;      // m, of the part
    double width = 0.0;       // m, of the narrower one of the two parts
    Mirror mirror = {};
    double muscle_strength = 0.0;  // SceneSettings::muscle_strength
    // In space: the depth of the shallower one and the limits of the further degrees of freedom.
    double depth = 0.0;  // m
    std::array<std::array<double, 2>, kMostDegrees - 1> further_limits = {};
};

struct JointKind {
    std::string id;     // written to files: "rigid", "rotary", "linear"
    std::string label;  // displayed name
    JointMotion motion = JointMotion::kFixed;
    bool usual = true;  // enabled in founders and mutations by default
    // Sets the limits and the motor's largest effort; required unless the joint is fixed.
    void (*shape)(const JointGenes& genes, PlannedPart& part) = nullptr;
    int turns = 1;  // hinges of a joint that turns; 3 of a ball

    int degrees_of_freedom() const { return motion == JointMotion::kFixed ? 0 : turns; }
};

using JointRegistry = Registry<JointKind>;

}  // namespace cambrian
