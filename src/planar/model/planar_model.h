#pragma once

// Articulated bodies as built from a plan: masses, joints and boxes in flat arrays, which never
// change during motion. Parts with rigid joints are one body. Bodies connected by joints form a
// tree; the trees are numbered one after the other, each depth first from its root. Boxes keep the
// order of the plan's parts. Slots beyond the counts are 0, so that loops may run to a multiple of
// the vector width.

#include "dynamics/simd.h"
#include "planar/model/dense_form.h"
#include "world/body_plan.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian {

// The numbers of one creature.
inline constexpr int kMostPlannedBodies = 32;
inline constexpr int kMostPlannedTrees = 8;
// Of several creatures that are advanced as one. Arrays of 60 numbers do not all begin at the same
// few places of the processor's cache, as those of 64 would.
inline constexpr int kMaxBodies = 60;
inline constexpr int kMaxParts = 64;
inline constexpr int kMaxTrees = 20;
inline constexpr int kContactsOfOne = 48;
inline constexpr int kMaxCoordinates = kMaxBodies + 2 * kMaxTrees;

using PerBody = double[kMaxBodies];
using PerPart = double[kMaxParts];
using PerCoordinate = double[kMaxCoordinates];
using PerTree = double[kMaxTrees];

using BodySet = std::uint64_t;  // one bit for each body

struct PartPair {
    std::uint8_t first = 0;
    std::uint8_t second = 0;
};

// The coefficients of the motor law, one formula for all modes (motors.cpp); 0 on roots.
struct MotorLaw {
    PerBody tracking = {};    // factor of the frequency, in the rate per distance to the target
    PerBody direct = {};      // factor of the target in the wanted rate
    PerBody rate_scale = {};  // factor of the speed limit: 1, or m for prismatic joints
    PerBody rate_floor = {};  // added to the speed limit
    PerBody stiffness = {};   // kg m^2 or kg; multiplied by the frequency it is the gain
    PerBody strength = {};    // N m or N; added to the gain
    PerBody damping = {};     // factor of the joint's rate, which is subtracted from the wanted one
};

// Which bodies belong to a tree.
struct TreeMembers {
    PerBody share = {};       // of the tree's mass, by body; 0 outside the tree
    PerBody membership = {};  // 1 for bodies of the tree, 0 for others
};

struct PlanarModel {
    int tree_count = 0;
    int body_count = 0;
    int part_count = 0;
    int contact_count = kContactsOfOne;  // largest number of contacts
    // Creatures that are advanced as one; their bodies follow each other.
    int member_count = 1;
    int member_begin[kMaxTrees + 1] = {};  // bodies; only for several creatures
    double density = 1.0;                  // kg/m^2, in all masses below
    double total_mass = 0.0;               // kg
    std::uint64_t measured_parts = 0;      // bits of the parts whose forces are measured

    int tree_begin[kMaxTrees + 1] = {};  // bodies of a tree: from its begin to the next one's
    PerTree tree_mass = {};              // kg
    std::vector<TreeMembers> members;    // of each tree

    PerBody mass = {};     // kg
    PerBody inertia = {};  // kg m^2, about the body's centre of mass
    PerBody inverse_mass = {}, inverse_inertia = {};

    // The joint of a body to its parent; unused on roots.
    JointMotion motion[kMaxBodies] = {};
    bool has_slides = false;
    int parent[kMaxBodies] = {};       // -1 on roots
    int parent_slot[kMaxBodies] = {};  // the parent, or the slot itself on roots and padding
    // All bodies by their depth in the trees, the roots first, and by number at the same depth.
    // Bodies of the same depth do not wait for each other, so the processor computes several at
    // once.
    int by_depth[kMaxBodies] = {};
    BodySet roots = 0;
    BodySet root_path[kMaxBodies] = {};                  // the bodies from this one to the root
    PerBody parent_anchor_x = {}, parent_anchor_y = {};  // m, in the parent's frame from its centre
    PerBody child_anchor_x = {}, child_anchor_y = {};    // m, in the body's frame from its centre
    PerBody pivot_x = {}, pivot_y = {};       // m, child anchor of revolute joints, else 0
    PerBody reach_x = {}, reach_y = {};       // m, parent anchor from the parent's pivot
    PerBody pivot_inertia = {};               // kg m^2, about the pivot
    PerBody rest_angle = {};                  // rad, relative to the parent
    PerBody axis_x = {}, axis_y = {};         // prismatic joints: unit, in the parent's frame
    PerBody limit_low = {}, limit_high = {};  // rad or m
    PerBody slides = {};                      // 0 on revolute joints and roots, else 1
    PerBody max_effort = {};                  // N m or N
    PerBody effective_inertia = {};           // kg m^2 or kg, of this joint alone in the rest pose
    MotorMode motor_mode[kMaxBodies] = {};
    MotorLaw motor;
    DenseForm dense;

    // The stretch of a deformable body has the slot after its body's: it is a joint without mass,
    // and its motion is kStretch (stretching.h). Only models with stretches keep rigid joints.
    int stretch_count = 0;
    int stretch_slot[kMaxBodies] = {};              // of a body's stretch, or -1
    PerBody length_square = {}, width_square = {};  // m^2; of half its length and width, over 3

    // Boxes.
    int part_body[kMaxParts] = {};
    int part_joint[kMaxParts] = {};    // body of the part's joint; -1: a root or a rigid joint
    PerPart part_x = {}, part_y = {};  // m, centre in the body's frame
    PerPart part_angle = {};           // rad, relative to the body
    PerPart part_cosine = {}, part_sine = {};   // of part_angle
    PerPart half_length = {}, half_width = {};  // m, along the box's x and y
    PerPart radius = {};                        // m, of the circle around the box
    double corner_x[4 * kMaxParts] = {};        // m, in the body's frame; bit 0 of the corner's
    double corner_y[4 * kMaxParts] = {};        // number is +x of the box, bit 1 is +y

    // The box of each body, if every body is one box (has_single_boxes); else 0.
    PerBody box_x = {}, box_y = {};                     // m, centre in the body's frame
    PerBody box_half_length = {}, box_half_width = {};  // m

    std::vector<PartPair> colliding_pairs;  // boxes of different bodies that may touch

    PerTree rest_center_x = {}, rest_center_y = {};  // m, centres of mass in the plan's rest pose
    PerTree rest_root_angle = {};                    // rad

    const TreeMembers& members_of(int tree) const {
        return members[static_cast<std::size_t>(tree)];
    }
};

// Sets the slots from one on as those of no body.
inline void clear_slots(PlanarModel& model, int first) {
    for (int slot = first; slot < kMaxBodies; ++slot) {
        model.parent_slot[slot] = slot;
        model.stretch_slot[slot] = -1;
    }
}

// Whether every body is one box and every slot is a body.
inline bool has_single_boxes(const PlanarModel& model) {
    return model.part_count == model.body_count && model.stretch_count == 0;
}

// Fills `by_depth` from the parents, which come before their children.
void order_by_depth(PlanarModel& model);

// Fills the members that follow from masses, inertias and joints.
void derive_inertias(PlanarModel& model);

// Scales all masses and inertias to another density.
void change_density(PlanarModel& model, double density);

// The state of articulated bodies and its rate of change (planar/README.md 1). The coordinates
// are (s_0 ... s_{n-1}, Cx and Cy of every tree). s_i is the ABSOLUTE angle of a root or of a body
// behind a revolute joint, the length of a prismatic joint, the stretch of a deformable body in its
// own slot, or always 0 at a rigid joint; C is the centre of mass of a tree.
// Joints cannot come apart in these coordinates. Slots beyond the count, up to a multiple of the
// vector width, are 0.

// Works that are integrated along with the motion, J, and one impulse, N m s: what drag and pulls
// give to the angular momentum about the centre of mass, in models of one tree.
enum Work : int { kMotorWork, kGrossMotorWork, kDragWork, kPullWork, kSpinGiven, kWorkCount };

struct Motion {
    PerCoordinate position;   // m or rad
    PerCoordinate speed;      // m/s or rad/s
    double work[kWorkCount];  // J, but for kSpinGiven
};

struct MotionRate {
    PerCoordinate acceleration;  // m/s^2 or rad/s^2
    double power[kWorkCount];    // W, but for kSpinGiven: N m
};

inline int coordinate_count(const PlanarModel& model) {
    return model.body_count + 2 * model.tree_count;
}
// The count rounded up to a multiple of the vector width.
inline int coordinate_slots(const PlanarModel& model) {
    return round_up_to_lanes(coordinate_count(model));
}
// Index of Cx of a tree; Cy follows. The coordinate of a body is its own number.
inline int center_of(const PlanarModel& model, int tree) {
    return model.body_count + 2 * tree;
}

inline void copy_motion(const PlanarModel& model, const Motion& from, Motion& to) {
    const int slots = coordinate_slots(model);
    for (int c = 0; c < slots; c += kLanes) {
        store_lanes(to.position + c, load_lanes(from.position + c));
        store_lanes(to.speed + c, load_lanes(from.speed + c));
    }
    std::memcpy(to.work, from.work, sizeof(to.work));
}
inline void copy_rate(const PlanarModel& model, const MotionRate& from, MotionRate& to) {
    const int slots = coordinate_slots(model);
    for (int c = 0; c < slots; c += kLanes)
        store_lanes(to.acceleration + c, load_lanes(from.acceleration + c));
    std::memcpy(to.power, from.power, sizeof(to.power));
}

// Returns the plan's rest pose without motion.
Motion rest_motion(const PlanarModel& model);

// All inputs of the accelerations besides the state: the medium, the targets of the motors in the
// current tick, and forces that are constant during a step or tick.

inline constexpr int kMaxContacts = 64;

struct Medium {
    double gravity_x = 0.0, gravity_y = 0.0;         // m/s^2
    double drag_linear = 0.0, drag_quadratic = 0.0;  // of Environment
};

// Whether an evaluation includes the damping of the motors in its equations (implicit) or not.
enum class Motors { kExplicit, kImplicit };

// Constants of the motor law, and the target of every joint, which ramps linearly over a tick.
struct MotorDrive {
    double frequency = 0.0;        // rad/s
    double speed_limit = 0.0;      // rad/s
    PerBody start = {}, end = {};  // target at the tick's start and end
};

// A force in world axes on a material point of body a. Its reaction acts on body b, if there is
// one, at the same position.
struct HeldForce {
    int body_a = 0;
    int body_b = -1;                      // -1 is the ground
    double point_x = 0.0, point_y = 0.0;  // m, in body a's frame
    double force_x = 0.0, force_y = 0.0;  // N
};

// Forces of contacts and joint limits, constant during a step.
struct HeldForces {
    int contact_count = 0;
    HeldForce contacts[kMaxContacts];
    bool limits_active = false;
    PerBody limit_effort = {};  // N m or N
};

struct Forcing {
    Medium medium;
    MotorDrive drive;
    const HeldForces* held = nullptr;  // null: no contact forces
    std::vector<HeldForce> pulls;      // of this tick; at most kMostPulls of each creature
};

}  // namespace cambrian
