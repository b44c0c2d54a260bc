#pragma once

// The plain data from which physics builds an articulated body. It is spatial; a planar scene uses
// x, y and rotations about z, and the first degree of freedom of a joint.

#include "math/pose.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace cambrian {

// The motion of a part relative to its parent that a joint allows (its motion subspace in the
// plane): none, rotation about the anchor, or a slide along the part's length. The last one is no
// joint but the stretch of a deformable part, which physics treats like one. In space a joint that
// turns may have several degrees of freedom (PlannedPart::axes), and there are balls.
enum class JointMotion : std::uint8_t { kFixed, kTurn, kSlide, kStretch, kBall };

// The quantity that a brain's signal sets: the joint's position, its rate, or its torque or force.
enum class MotorMode : std::uint8_t { kPosition, kVelocity, kTorque };
inline constexpr std::array<std::string_view, 3> kMotorModeIds = {"position", "velocity",
                                                                  "torque"};  // in that order

// Faces of a box-shaped part in its own frame; the order is that of the contact channels
// (creature/README.md 2): distal +x, left +y, proximal -x, right -y; in space also front +z, back
// -z.
enum class Face : std::uint8_t { kDistal, kLeft, kProximal, kRight, kFront, kBack };
inline constexpr std::size_t kFaceCount = 6;

// A joint in space has at most this many degrees of freedom.
inline constexpr std::size_t kMostDegrees = 3;

// One degree of freedom of one part's joint to its parent.
struct JointDegree {
    std::uint16_t part = 0;
    std::uint8_t degree = 0;  // below kMostDegrees; 0 in the plane

    friend bool operator==(const JointDegree&, const JointDegree&) = default;
};

// The stops and the motor of a degree of freedom.
struct DegreeLimits {
    double low = 0.0;         // rad or m, from rest; <= 0
    double high = 0.0;        // rad or m, from rest; >= 0
    double max_effort = 0.0;  // N m or N; largest effort of the motor
};

// The stretch s of a deformable part: its length is e^s and its width e^-s times that at rest, so
// its area is constant.
struct PlannedStretch {
    double low = 0.0;         // limits of s; <= 0
    double high = 0.0;        // >= 0
    double max_effort = 0.0;  // J; largest effort of the motor on s
    double rate_limit = 0.0;  // 1/s; fastest that the motor stretches the part
};

// A box and the joint that connects it to its parent. The part's frame is at its centre, with x
// along its length.
struct PlannedPart {
    Vec3 half_extents = Vec3::Zero();  // m; z is ignored by planar scenes
    Pose rest_pose;                    // world pose before any motion
    double rest_angle = 0.0;           // rad; planar angle of rest_pose, unwrapped
    int parent = -1;                   // index of an earlier part; -1 on the root
    // The joint to the parent; unused on the root.
    JointMotion motion = JointMotion::kFixed;
    Vec3 anchor_in_parent = Vec3::Zero();  // m, in the parent's frame
    Vec3 anchor_in_child = Vec3::Zero();   // m, in this part's frame
    double limit_low = 0.0;                // rad or m, from rest; <= 0
    double limit_high = 0.0;               // rad or m, from rest; >= 0
    double max_effort = 0.0;               // N m or N; largest effort of the motor
    MotorMode motor_mode = MotorMode::kPosition;
    bool measures_forces = false;                // whether its specific force and load are needed
    std::optional<PlannedStretch> stretch = {};  // of a deformable part
    // In space, a joint that turns has hinges about these axes of the part's frame (x, y, z), each
    // of which turns those after it. The limits above are those of the first. A ball bends about z
    // and y and twists about x; both bends together are at most the high limit of the first.
    std::uint8_t degree_count = 1;
    std::array<std::uint8_t, kMostDegrees> axes = {2, 1, 0};
    std::array<DegreeLimits, kMostDegrees - 1> further = {};  // of the others
};

inline DegreeLimits limits_of(const PlannedPart& part, std::size_t degree) {
    if (degree == 0) return {part.limit_low, part.limit_high, part.max_effort};
    return part.further[degree - 1];
}

// Returns how often a part's joint moves: 0 if it is rigid.
inline std::size_t degrees_of(const PlannedPart& part) {
    return part.motion == JointMotion::kFixed ? 0 : part.degree_count;
}

// parts[0] is the root; every parent comes before its children.
struct BodyPlan {
    std::vector<PlannedPart> parts;
};

}  // namespace cambrian
