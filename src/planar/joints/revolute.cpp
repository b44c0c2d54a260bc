// A revolute joint about the anchor. Strength is proportional to the square of the narrower section
// of the two parts, because a thicker muscle also has a longer lever.

#include "planar/joints/builtin_joints.h"

namespace cambrian {
namespace {

void shape_revolute(const JointGenes& genes, PlannedPart& part) {
    const bool mirrored = genes.mirror.across < 0;
    part.limit_low = mirrored ? -genes.limit_high : genes.limit_low;
    part.limit_high = mirrored ? -genes.limit_low : genes.limit_high;
    part.max_effort = genes.muscle_strength * genes.width * genes.width;
}

}  // namespace

void add_revolute_joint(JointRegistry& joints) {
    joints.add({.id = "rotary",
                .label = "Revolute",
                .motion = JointMotion::kTurn,
                .shape = shape_revolute});
}

}  // namespace cambrian
