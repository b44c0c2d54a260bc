#include "support/body_plans.h"

#include "math/elementary.h"

#include <cmath>

namespace cambrian {

BodyPlan one_box(double half_length, double half_width, double x, double y, double angle) {
    PlannedPart root;
    root.half_extents = Vec3(half_length, half_width, half_width);
    root.rest_pose = planar_pose(x, y, angle);
    root.rest_angle = angle;
    return {{root}};
}

void join(const BodyPlan& plan, PlannedPart& child, int parent, const Vec3& anchor, double angle) {
    const PlannedPart& base = plan.parts[static_cast<std::size_t>(parent)];
    child.parent = parent;
    child.anchor_in_parent = anchor;
    child.anchor_in_child = Vec3(-child.half_extents.x(), 0.0, 0.0);
    child.rest_angle = base.rest_angle + angle;
    child.rest_pose = planar_pose(0.0, 0.0, child.rest_angle);
    child.rest_pose.position =
        transform(base.rest_pose, anchor) - child.rest_pose.orientation * child.anchor_in_child;
}

PlannedPart& attach(BodyPlan& plan, int parent, const Vec3& anchor, double angle, JointMotion joint,
                    double half_length, double half_width) {
    PlannedPart part;
    part.motion = joint;
    part.half_extents = Vec3(half_length, half_width, half_width);
    part.limit_low = -1.0;
    part.limit_high = 1.0;
    join(plan, part, parent, anchor, angle);
    plan.parts.push_back(part);
    return plan.parts.back();
}

void make_deformable(PlannedPart& part, double low, double high) {
    const double area = 4.0 * part.half_extents.x() * part.half_extents.y();
    part.stretch = PlannedStretch{low, high, 25.0 * area, 1.5};
}

BodyPlan chain(int parts, double limit, double x, double y) {
    BodyPlan plan = one_box(0.2, 0.05, x, y);
    for (int i = 1; i < parts; ++i) {
        PlannedPart& part = attach(plan, i - 1, Vec3(0.2, 0.0, 0.0), 0.0, kRotaryJoint);
        part.limit_low = -limit;
        part.limit_high = limit;
    }
    return plan;
}

BodyPlan random_tree(RandomStream& random, int parts, double linear_share, double strength,
                     double height) {
    // Each draw is a separate statement, since compilers evaluate arguments in different orders.
    const auto half_width = [&] { return random.uniform(0.03, 0.1); };
    const auto half_length = [&] { return random.uniform(0.1, 0.35); };
    const double root_width = half_width();
    BodyPlan plan = one_box(half_length(), root_width, 0.0, height);
    for (int i = 1; i < parts; ++i) {
        const int parent =
            random.chance(1.0 / 3) ? static_cast<int>(random.below(plan.parts.size())) : i - 1;
        const Vec3 half = plan.parts[static_cast<std::size_t>(parent)].half_extents;
        const bool linear = random.chance(linear_share);
        const double width = half_width();
        const double length = half_length();
        const double angle = random.uniform(-1.2, 1.2);
        const Vec3 anchor(half.x(), random.uniform(-0.9, 0.9) * half.y(), 0.0);
        PlannedPart& part = attach(plan, parent, anchor, angle,
                                   linear ? kLinearJoint : kRotaryJoint, length, width);
        const double limit = linear ? 0.1 : random.uniform(0.4, 1.2);
        part.limit_low = -limit;
        part.limit_high = limit;
        part.max_effort = strength * 2.0 * std::fmin(half.y(), part.half_extents.y());
    }
    return plan;
}

Environment empty_space() {
    Environment environment;
    environment.gravity = 0.0;
    environment.has_ground = false;
    return environment;
}

Environment open_water() {
    Environment environment = empty_space();
    environment.viscosity_linear = 0.5;
    environment.viscosity_quadratic = 5.0;
    return environment;
}

void stand_on_ground(PhysicsScene& scene) {
    scene.translate(Vec3(0.0, 0.02 - scene.bounds().low.y(), 0.0));
    scene.restart_audit();
}

bool run(PhysicsScene& scene, double duration) {
    const int ticks = static_cast<int>(std::lround(duration / kTestTick));
    for (int i = 0; i < ticks; ++i) {
        if (scene.advance(kTestTick) != SceneStatus::kRunning) return false;
    }
    return true;
}

void flail(PhysicsScene& scene, const BodyPlan& plan, double max_frequency) {
    for (std::size_t i = 1; i < plan.parts.size(); ++i) {
        const double frequency =
            max_frequency * (0.2 + 0.8 * static_cast<double>(i * 7 % 11) / 11.0);
        const double phase = static_cast<double>(i);
        scene.set_target(
            i, plan.parts[i].limit_high * sine(2.0 * kPi * frequency * scene.time() + phase));
    }
}

}  // namespace cambrian
