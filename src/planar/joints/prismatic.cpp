// A prismatic joint along the length of its part. Its genes are in lengths of the part, and
// mirroring does not change them. Strength is proportional to the narrower section of the two
// parts.

#include "planar/joints/builtin_joints.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kMaxExtension = 0.9;  // share of the part's length, in both directions

void shape_prismatic(const JointGenes& genes, PlannedPart& part) {
    part.limit_low = std::fmax(genes.limit_low, -kMaxExtension) * genes.length;
    part.limit_high = std::fmin(genes.limit_high, kMaxExtension) * genes.length;
    part.max_effort = genes.muscle_strength * genes.width;
}

}  // namespace

void add_prismatic_joint(JointRegistry& joints) {
    joints.add({.id = "linear",
                .label = "Prismatic",
                .motion = JointMotion::kSlide,
                .usual = false,
                .shape = shape_prismatic});
}

}  // namespace cambrian
