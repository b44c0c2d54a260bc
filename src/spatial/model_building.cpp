#include "spatial/articulated_body.h"
#include "world/scene_checks.h"

#include <fmt/core.h>

#include <cmath>
#include <string>

namespace cambrian::spatial {
namespace {

bool is_finite(const Vec3& v) {
    return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z());
}

bool is_finite(const PlannedPart& part) {
    const Rotation& q = part.rest_pose.orientation;
    return is_finite(part.half_extents) && is_finite(part.rest_pose.position) &&
           is_finite(part.anchor_in_parent) && is_finite(part.anchor_in_child) &&
           std::isfinite(q.w() + q.x() + q.y() + q.z());
}

Status check_joint(const PlannedPart& part, std::size_t index) {
    const bool is_ball = part.motion == JointMotion::kBall;
    if (part.motion > JointMotion::kSlide && !is_ball)
        return part_error(index, "unknown motion of its joint");
    if (is_ball && !(part.degree_count == kMostDegrees && part.limit_high < kPi))
        return part_error(index, "a ball has 3 degrees of freedom and bends by less than pi");
    if (part.degree_count < 1 || part.degree_count > kMostDegrees)
        return part_error(index, "a joint has 1 to 3 degrees of freedom");
    for (std::size_t d = 0; d < part.degree_count; ++d) {
        const DegreeLimits limits = limits_of(part, d);
        if (!std::isfinite(limits.low + limits.high + limits.max_effort))
            return part_error(index, "a number is not finite");
        if (!(limits.low <= limits.high)) return part_error(index, "limits in wrong order");
        if (limits.max_effort < 0.0) return part_error(index, "negative motor effort");
        if (part.axes[d] > 2) return part_error(index, "unknown axis of its joint");
    }
    return {};
}

Status check_part(const BodyPlan& plan, std::size_t index) {
    const PlannedPart& part = plan.parts[index];
    if (!is_finite(part)) return part_error(index, "a number is not finite");
    if (!(part.half_extents.minCoeff() >= kMinHalfExtent))
        return part_error(index, "thinner than 2 cm");
    if (part.stretch) return part_error(index, "deformers are not built in space yet");
    const bool is_root = part.parent < 0;
    if ((index == 0) != is_root || part.parent >= static_cast<int>(index))
        return part_error(index, "part 0 is the root, and parents come before children");
    return is_root ? Status() : check_joint(part, index);
}

double mass_of(const PlannedPart& part, double density) {
    const Vec3& half = part.half_extents;
    return 8.0 * density * half.x() * half.y() * half.z();
}

// Fills the model from the plan, step by step.
class ModelBuilder {
public:
    ModelBuilder(const BodyPlan& plan, double density) : plan_(plan) { model_.density = density; }

    Result<Model> build() {
        model_.part_count = static_cast<int>(plan_.parts.size());
        for (int i = 0; i < model_.part_count; ++i) {
            model_.measured[i] = planned(i).measures_forces;
            join_body(i);
        }
        place_centers();
        for (int i = 0; i < model_.part_count; ++i)
            place_part(i);
        for (int b = 0; b < model_.body_count; ++b) {
            if (model_.bodies[b].mass < kMinMassShare * model_.mass)
                return part_error(static_cast<std::size_t>(leader_[b]),
                                  fmt::format("lighter than {} of the body", kMinMassShare));
            if (b > 0) add_joint(b);
        }
        set_motors();
        return model_;
    }

private:
    const PlannedPart& planned(int part) const {
        return plan_.parts[static_cast<std::size_t>(part)];
    }
    Turn axes_of(int body) const { return turn_of(planned(leader_[body]).rest_pose.orientation); }

    // A part with a rigid joint belongs to its parent's body.
    void join_body(int part) {
        const PlannedPart& plan = planned(part);
        const bool welded = part > 0 && plan.motion == JointMotion::kFixed;
        int& body = model_.parts[part].body;
        body = welded ? model_.parts[plan.parent].body : model_.body_count;
        if (!welded) leader_[model_.body_count++] = part;
        const double mass = mass_of(plan, model_.density);
        model_.bodies[body].mass += mass;
        model_.mass += mass;
        center_[body].place += mass * plan.rest_pose.position;
    }

    void place_centers() {
        for (int b = 0; b < model_.body_count; ++b) {
            model_.center += center_[b].place;
            center_[b].place /= model_.bodies[b].mass;
        }
        model_.center /= model_.mass;
        model_.root_turn = axes_of(0);
    }

    void place_part(int index) {
        const PlannedPart& plan = planned(index);
        Part& part = model_.parts[index];
        const Turn axes = axes_of(part.body);
        part.place = axes.back(plan.rest_pose.position - center_[part.body].place);
        part.turn = axes.back(turn_of(plan.rest_pose.orientation));
        part.half = plan.half_extents;
        part.radius = std::sqrt(dot(part.half, part.half));
        const double mass = mass_of(plan, model_.density);
        const Vec3 squares = part.half.cwiseProduct(part.half);
        const Symmetric box{mass / 3.0 * (squares.y() + squares.z()),
                            mass / 3.0 * (squares.x() + squares.z()),
                            mass / 3.0 * (squares.x() + squares.y())};
        Symmetric& inertia = model_.bodies[part.body].inertia;
        inertia += turned(box, part.turn);
        inertia += point_inertia(mass, part.place);
    }

    void add_joint(int b) {
        Body& body = model_.bodies[b];
        const PlannedPart& plan = planned(leader_[b]);
        const Part& from = model_.parts[plan.parent];
        const Part& own = model_.parts[leader_[b]];
        body.parent = from.body;
        body.joint_frame = axes_of(from.body).back(axes_of(b));
        body.pivot_in_parent = from.place + from.turn * plan.anchor_in_parent;
        body.pivot_in_body = own.place + own.turn * plan.anchor_in_child;
        body.first_degree = model_.degree_count;
        const bool slides = plan.motion == JointMotion::kSlide;
        body.degree_count = slides ? 1 : plan.degree_count;
        body.is_ball = plan.motion == JointMotion::kBall;
        if (body.is_ball) model_.balls[model_.ball_count++] = b;
        for (int d = 0; d < body.degree_count; ++d) {
            const DegreeLimits limits = limits_of(plan, static_cast<std::size_t>(d));
            model_.degrees[model_.degree_count++] = {
                .body = b,
                .axis = slides         ? 0
                        : body.is_ball ? 2 - d
                                       : plan.axes[static_cast<std::size_t>(d)],
                .slides = slides,
                .low = limits.low,
                .high = limits.high,
                .max_effort = limits.max_effort,
                .mode = plan.motor_mode,
                .rate_scale = slides ? kRateLengthShare * 2.0 * plan.half_extents.x() : 1.0};
        }
    }

    // A degree's inertia is 1 / (its acceleration under a unit effort at it alone).
    void set_motors() {
        const Motion rest = rest_motion(model_);
        Kinematics kinematics;
        compute_kinematics(model_, rest, kinematics);
        Factors factors;
        Response response;
        solve_accelerations(model_, kinematics, {}, factors, response);
        Push push;
        for (int d = 0; d < model_.degree_count; ++d) {
            push.effort[d] = 1.0;
            respond(model_, kinematics, factors, push, response);
            push.effort[d] = 0.0;
            model_.degrees[d].inertia = 1.0 / response.joint[d];
        }
    }

    const BodyPlan& plan_;
    Model model_;
    int leader_[kMostBodies] = {};
    // m, world at rest; times the mass until that is known.
    struct Center {
        Vec3 place = Vec3::Zero();
    };
    Center center_[kMostBodies];
};

}  // namespace

Result<Model> build_model(const BodyPlan& plan, double density) {
    if (Status status = check_plan(plan, density, kMostParts, check_part); !status)
        return status.error();
    return ModelBuilder(plan, density).build();
}

void change_density(Model& model, double density) {
    const double factor = density / model.density;
    model.density = density;
    model.mass *= factor;
    for (int b = 0; b < model.body_count; ++b) {
        Body& body = model.bodies[b];
        body.mass *= factor;
        for (double* number : {&body.inertia.xx, &body.inertia.yy, &body.inertia.zz,
                               &body.inertia.xy, &body.inertia.xz, &body.inertia.yz})
            *number *= factor;
    }
    for (int d = 0; d < model.degree_count; ++d)
        model.degrees[d].inertia *= factor;
}

}  // namespace cambrian::spatial
