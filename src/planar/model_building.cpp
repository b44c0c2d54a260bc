#include "planar/model_building.h"

#include "math/elementary.h"
#include "planar/articulated/articulated_body.h"
#include "planar/constraints/invariants.h"
#include "planar/forces/motors.h"
#include "planar/model/collision_filter.h"
#include "world/scene_checks.h"

#include <fmt/core.h>

#include <cmath>
#include <string>

namespace cambrian {
namespace {

constexpr double kMaxStretch = 1.0;    // largest |s|
constexpr double kStretchSpare = 0.1;  // that a stretch may overrun its limits, for the broad phase
constexpr double kFixedRoom = 1.0;     // to the limits of rigid joints, which never move

bool is_finite(const PlannedPart& part) {
    const double numbers[] = {part.half_extents.x(),
                              part.half_extents.y(),
                              part.rest_pose.position.x(),
                              part.rest_pose.position.y(),
                              part.rest_angle,
                              part.anchor_in_parent.x(),
                              part.anchor_in_parent.y(),
                              part.anchor_in_child.x(),
                              part.anchor_in_child.y(),
                              part.limit_low,
                              part.limit_high,
                              part.max_effort};
    for (const double number : numbers) {
        if (!std::isfinite(number)) return false;
    }
    return true;
}

Status check_stretch(const PlannedStretch& stretch, std::size_t index) {
    for (const double number :
         {stretch.low, stretch.high, stretch.max_effort, stretch.rate_limit}) {
        if (!std::isfinite(number))
            return part_error(index, "a number of its stretch is not finite");
    }
    if (!(stretch.low <= 0.0 && stretch.high >= 0.0))
        return part_error(index, "limits of its stretch exclude its rest shape");
    if (stretch.low < -kMaxStretch || stretch.high > kMaxStretch)
        return part_error(index, fmt::format("stretches by more than e^{}", kMaxStretch));
    if (stretch.max_effort < 0.0 || stretch.rate_limit < 0.0)
        return part_error(index, "negative effort or speed of its stretch");
    return {};
}

Status check_part(const BodyPlan& plan, std::size_t index) {
    const PlannedPart& part = plan.parts[index];
    if (!is_finite(part)) return part_error(index, "a number is not finite");
    if (part.half_extents.x() < kMinHalfExtent || part.half_extents.y() < kMinHalfExtent)
        return part_error(index, "thinner than 2 cm");
    if (part.stretch) {
        if (Status status = check_stretch(*part.stretch, index); !status) return status;
    }
    const bool is_root = part.parent < 0;
    if ((index == 0 && !is_root) || part.parent >= static_cast<int>(index))
        return part_error(index, "part 0 is a root, and parents come before children");
    if (is_root) return {};
    if (part.motion > JointMotion::kSlide) return part_error(index, "unknown motion of its joint");
    if (!(part.limit_low <= part.limit_high)) return part_error(index, "limits in wrong order");
    if (part.max_effort < 0.0) return part_error(index, "negative motor effort");
    return {};
}

// Fills the model from the plan, step by step.
class ModelBuilder {
public:
    ModelBuilder(const BodyPlan& plan, double density) : plan_(plan) {
        model_.density = density;
        model_.part_count = static_cast<int>(plan.parts.size());
        for (std::size_t i = 0; i < plan.parts.size(); ++i)
            model_.measured_parts |= std::uint64_t{plan.parts[i].measures_forces} << i;
        clear_slots(model_, 0);
    }

    Result<PlanarModel> build() {
        if (Status status = plant_trees(); !status) return status.error();
        order_by_depth(model_);
        for (int i = 0; i < model_.part_count; ++i)
            add_mass(i);
        for (int b = 0; b < model_.body_count; ++b) {
            if (!is_stretch(b) && model_.mass[b] < kMinMassShare * model_.total_mass)
                return part_error(static_cast<std::size_t>(leader_[b]),
                                  "lighter than 1e-4 of the body");
        }
        center_bodies();
        for (int i = 0; i < model_.part_count; ++i)
            place_box(i);
        fill_spare_parts();
        if (has_single_boxes(model_)) give_bodies_their_boxes();
        for (int b = 0; b < model_.body_count; ++b)
            place_joint(b);
        weigh_trees();
        derive_inertias(model_);
        set_motors();
        CAMBRIAN_ASSERT(are_parents_before_children(model_), "a parent comes before its children");
        CAMBRIAN_ASSERT(are_bodies_sound(), "bodies have masses, joints have stops in order");
        CAMBRIAN_ASSERT(model_.tree_begin[model_.tree_count] == model_.body_count,
                        "every body is in a tree");
        model_.colliding_pairs = find_colliding_pairs(model_, plan_);
        return std::move(model_);
    }

private:
    const PlannedPart& part(int i) const { return plan_.parts[static_cast<std::size_t>(i)]; }
    bool deforms(int i) const { return part(i).stretch.has_value(); }
    bool is_stretch(int slot) const { return model_.motion[slot] == JointMotion::kStretch; }

    bool are_bodies_sound() const {
        for (int b = 0; b < model_.body_count; ++b) {
            if (is_stretch(b)) continue;
            const bool has_joint = model_.parent[b] >= 0 && model_.motion[b] != JointMotion::kFixed;
            if (!(model_.mass[b] > 0.0 && model_.inertia[b] > 0.0)) return false;
            if (has_joint && model_.limit_low[b] > model_.limit_high[b]) return false;
            if (has_joint && !(model_.effective_inertia[b] > 0.0)) return false;
        }
        return true;
    }

    // Numbers the bodies, tree after tree.
    Status plant_trees() {
        for (int i = 0; i < model_.part_count; ++i) {
            if (part(i).parent >= 0) continue;
            if (model_.tree_count == kMostPlannedTrees)
                return Error{fmt::format("body plan: over {} separate bodies", kMostPlannedTrees)};
            model_.tree_begin[model_.tree_count++] = model_.body_count;
            if (!visit(i, -1))
                return Error{fmt::format("body plan: over {} moving bodies", kMostPlannedBodies)};
            model_.tree_begin[model_.tree_count] = model_.body_count;
        }
        return {};
    }

    bool is_welded(int index, int parent_body) const {
        return parent_body >= 0 && part(index).motion == JointMotion::kFixed && !deforms(index) &&
               !deforms(part(index).parent);
    }

    // Adds a slot behind another one, or for a root. There must be room.
    int add_slot(int index, int parent) {
        const int slot = model_.body_count++;
        leader_[slot] = index;
        model_.parent[slot] = parent;
        if (parent >= 0) model_.parent_slot[slot] = parent;
        const BodySet path = parent < 0 ? 0 : model_.root_path[parent];
        if (parent < 0) model_.roots |= BodySet{1} << slot;
        model_.root_path[slot] = path | (BodySet{1} << slot);
        return slot;
    }

    // Adds a part and its subtree. A part with a rigid joint joins its parent's body if neither
    // deforms; any other part starts a new body, followed by its stretch if it deforms.
    bool visit(int index, int parent_body) {
        int body = parent_body;
        if (!is_welded(index, parent_body)) {
            if (model_.body_count + (deforms(index) ? 2 : 1) > kMostPlannedBodies) return false;
            body = add_slot(index, parent_body);
            if (deforms(index)) {
                const int slot = add_slot(index, body);
                model_.motion[slot] = JointMotion::kStretch;
                model_.stretch_slot[body] = slot;
                ++model_.stretch_count;
            }
        }
        model_.part_body[index] = body;
        model_.part_joint[index] = -1;
        for (int child = index + 1; child < model_.part_count; ++child) {
            if (part(child).parent == index && !visit(child, body)) return false;
        }
        return true;
    }

    double area_mass(int index) const {
        return 4.0 * model_.density * part(index).half_extents.x() * part(index).half_extents.y();
    }

    void add_mass(int index) {
        const int b = model_.part_body[index];
        const double mass = area_mass(index);
        CAMBRIAN_TICK_ASSERT(mass > 0.0, "a box has an area");
        model_.mass[b] += mass;
        model_.total_mass += mass;
        center_x_[b] += mass * part(index).rest_pose.position.x();
        center_y_[b] += mass * part(index).rest_pose.position.y();
    }

    void center_bodies() {
        for (int b = 0; b < model_.body_count; ++b) {
            if (is_stretch(b)) continue;
            center_x_[b] /= model_.mass[b];
            center_y_[b] /= model_.mass[b];
            rest_turn_[b] = sine_cosine(part(leader_[b]).rest_angle);
        }
    }

    // Transforms a point from the world to a body's frame, in the rest pose.
    Vec2 to_body(int b, double x, double y) const {
        const double dx = x - center_x_[b];
        const double dy = y - center_y_[b];
        return {rest_turn_[b].cosine * dx + rest_turn_[b].sine * dy,
                rest_turn_[b].cosine * dy - rest_turn_[b].sine * dx};
    }

    // Transforms a point from a part's frame to its body's frame.
    Vec2 part_point(int index, const Vec3& point) const {
        return {model_.part_x[index] + model_.part_cosine[index] * point.x() -
                    model_.part_sine[index] * point.y(),
                model_.part_y[index] + model_.part_sine[index] * point.x() +
                    model_.part_cosine[index] * point.y()};
    }

    void place_box(int index) {
        const PlannedPart& box = part(index);
        const int b = model_.part_body[index];
        const Vec2 offset = to_body(b, box.rest_pose.position.x(), box.rest_pose.position.y());
        const double angle = box.rest_angle - part(leader_[b]).rest_angle;
        const SineCosine turn = sine_cosine(angle);
        model_.part_x[index] = offset.x();
        model_.part_y[index] = offset.y();
        model_.part_angle[index] = angle;
        model_.part_cosine[index] = turn.cosine;
        model_.part_sine[index] = turn.sine;
        const double hx = box.half_extents.x();
        const double hy = box.half_extents.y();
        model_.half_length[index] = hx;
        model_.half_width[index] = hy;
        model_.radius[index] = radius_of(box);
        for (int corner = 0; corner < 4; ++corner) {
            const double x = (corner & 1) != 0 ? hx : -hx;
            const double y = (corner & 2) != 0 ? hy : -hy;
            const Vec2 point = part_point(index, Vec3(x, y, 0.0));
            model_.corner_x[4 * index + corner] = point.x();
            model_.corner_y[4 * index + corner] = point.y();
        }
        model_.inertia[b] += area_mass(index) * ((hx * hx + hy * hy) / 3.0 + offset.squaredNorm());
    }

    // The radius of a box in its widest shape.
    static double radius_of(const PlannedPart& box) {
        const double hx = box.half_extents.x();
        const double hy = box.half_extents.y();
        if (!box.stretch) return std::sqrt(hx * hx + hy * hy);
        double widest = 0.0;
        for (const double s :
             {box.stretch->low - kStretchSpare, box.stretch->high + kStretchSpare}) {
            const double length = hx * exponential(s);
            const double width = hy * exponential(-s);
            widest = std::fmax(widest, std::sqrt(length * length + width * width));
        }
        return widest;
    }

    // Padding slots move as part 0 and have no faces.
    void fill_spare_parts() {
        for (int i = model_.part_count; i < round_up_to_lanes(model_.part_count); ++i) {
            model_.part_body[i] = model_.part_body[0];
            model_.part_x[i] = model_.part_x[0];
            model_.part_y[i] = model_.part_y[0];
        }
    }

    void give_bodies_their_boxes() {
        for (int i = 0; i < model_.part_count; ++i) {
            const int b = model_.part_body[i];
            model_.box_x[b] = model_.part_x[i];
            model_.box_y[b] = model_.part_y[i];
            model_.box_half_length[b] = model_.half_length[i];
            model_.box_half_width[b] = model_.half_width[i];
        }
    }

    void place_stretch(int slot) {
        const int b = model_.parent[slot];
        const PlannedPart& box = part(leader_[slot]);
        model_.length_square[b] = box.half_extents.x() * box.half_extents.x() / 3.0;
        model_.width_square[b] = box.half_extents.y() * box.half_extents.y() / 3.0;
        model_.limit_low[slot] = box.stretch->low;
        model_.limit_high[slot] = box.stretch->high;
        model_.max_effort[slot] = box.stretch->max_effort;
        model_.motor_mode[slot] = MotorMode::kPosition;
        model_.slides[slot] = 1.0;
    }

    void place_joint(int b) {
        const int p = model_.parent[b];
        if (p < 0) return;
        if (is_stretch(b)) return place_stretch(b);
        const int index = leader_[b];
        const PlannedPart& child = part(index);
        CAMBRIAN_TICK_ASSERT(child.parent >= 0 && child.parent < index,
                             "a parent comes before its children");
        const Vec2 in_parent = part_point(child.parent, child.anchor_in_parent);
        const Vec2 in_child = part_point(index, child.anchor_in_child);
        model_.motion[b] = child.motion;
        if (child.motion != JointMotion::kFixed) model_.part_joint[index] = b;
        model_.parent_anchor_x[b] = in_parent.x();
        model_.parent_anchor_y[b] = in_parent.y();
        model_.child_anchor_x[b] = in_child.x();
        model_.child_anchor_y[b] = in_child.y();
        model_.rest_angle[b] = child.rest_angle - part(leader_[p]).rest_angle;
        const SineCosine turn = sine_cosine(model_.rest_angle[b]);
        model_.axis_x[b] = turn.cosine;  // a prismatic joint slides along its child's length
        model_.axis_y[b] = turn.sine;
        model_.limit_low[b] = child.limit_low;
        model_.limit_high[b] = child.limit_high;
        model_.max_effort[b] = child.max_effort;
        model_.motor_mode[b] = child.motor_mode;
        const bool is_prismatic = model_.motion[b] == JointMotion::kSlide;
        model_.slides[b] = is_prismatic ? 1.0 : 0.0;
        model_.pivot_x[b] = is_prismatic ? 0.0 : in_child.x();
        model_.pivot_y[b] = is_prismatic ? 0.0 : in_child.y();
        model_.reach_x[b] = in_parent.x() - model_.pivot_x[p];
        model_.reach_y[b] = in_parent.y() - model_.pivot_y[p];
        model_.has_slides = model_.has_slides || is_prismatic;
        if (child.motion != JointMotion::kFixed) return;
        model_.slides[b] = 1.0;
        model_.limit_low[b] = -kFixedRoom;
        model_.limit_high[b] = kFixedRoom;
        model_.max_effort[b] = 0.0;
    }

    void weigh_trees() {
        for (int t = 0; t < model_.tree_count; ++t) {
            const int begin = model_.tree_begin[t];
            const int end = model_.tree_begin[t + 1];
            TreeMembers& members = model_.members.emplace_back();
            for (int b = begin; b < end; ++b)
                model_.tree_mass[t] += model_.mass[b];
            for (int b = begin; b < end; ++b) {
                const double share = model_.mass[b] / model_.tree_mass[t];
                members.share[b] = share;
                members.membership[b] = 1.0;
                model_.rest_center_x[t] += share * center_x_[b];
                model_.rest_center_y[t] += share * center_y_[b];
            }
            model_.rest_root_angle[t] = part(leader_[begin]).rest_angle;
        }
    }

    // I_eff = 1 / (relative acceleration under a unit effort at this joint alone).
    void set_motors() {
        const Motion rest = rest_motion(model_);
        Kinematics kinematics;
        Factors factors;
        BodyResponse response;
        Loads loads;
        clear_loads(model_, loads);
        compute_kinematics(model_, rest, kinematics);
        solve_accelerations(model_, kinematics, loads, factors, response);
        for (int b = 0; b < model_.body_count; ++b) {
            if (model_.parent[b] < 0 || model_.motion[b] == JointMotion::kFixed) continue;
            loads.effort[b] = 1.0;
            solve_impulse(model_, kinematics, factors, loads, response);
            loads.effort[b] = 0.0;
            const bool is_prismatic = model_.motion[b] == JointMotion::kSlide;
            double jump = response.coordinate[b];
            if (model_.motion[b] == JointMotion::kTurn) jump -= response.spin[model_.parent[b]];
            model_.effective_inertia[b] = 1.0 / jump;
            if (is_stretch(b)) {
                set_motor_law(model_, b, 0.0);
                model_.motor.rate_floor[b] = part(leader_[b]).stretch->rate_limit;
                continue;
            }
            const double length = 2.0 * part(leader_[b]).half_extents.x();
            set_motor_law(model_, b, is_prismatic ? kRateLengthShare * length : 1.0);
        }
    }

    const BodyPlan& plan_;
    PlanarModel model_;
    int leader_[kMaxBodies] = {};
    PerBody center_x_ = {}, center_y_ = {};
    SineCosine rest_turn_[kMaxBodies] = {};
};

}  // namespace

Result<PlanarModel> build_planar_model(const BodyPlan& plan, double density) {
    if (Status status = check_plan(plan, density, kMaxParts, check_part); !status)
        return status.error();
    return ModelBuilder(plan, density).build();
}

}  // namespace cambrian
