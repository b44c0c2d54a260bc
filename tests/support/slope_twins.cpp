#include "support/slope_twins.h"

#include "core/assert.h"
#include "math/angle.h"
#include "support/body_plans.h"

#include <fmt/format.h>

#include <algorithm>

namespace cambrian {
namespace {

Vec3 turned_point(const Vec3& at, double angle) {
    const SineCosine turn = sine_cosine(angle);
    return {turn.cosine * at.x() - turn.sine * at.y(), turn.sine * at.x() + turn.cosine * at.y(),
            0.0};
}

BodyPlan turned_plan(BodyPlan plan, double angle) {
    for (PlannedPart& part : plan.parts) {
        const Vec3 at = turned_point(part.rest_pose.position, angle);
        part.rest_angle += angle;
        part.rest_pose = planar_pose(at.x(), at.y(), part.rest_angle);
    }
    return plan;
}

Environment sloping_ground(double angle) {
    constexpr double kFarAway = 100.0;  // m
    const SineCosine turn = sine_cosine(angle);
    const double rise = kFarAway * turn.sine / turn.cosine;
    Environment environment;
    environment.terrain.kind = "drawn";
    environment.terrain.points = fmt::format("{} {}; {} {}", -kFarAway, -rise, kFarAway, rise);
    return environment;
}

std::unique_ptr<PhysicsScene> made(const SceneKind& physics, const BodyPlan& plan,
                                   const Environment& environment, const SceneSettings& settings) {
    auto scene = physics.make(plan, environment, settings);
    CAMBRIAN_ASSERT(scene.has_value(), "physics takes the bodies of tests");
    return std::move(*scene);
}

}  // namespace

SlopeTwins::SlopeTwins(const SceneKind& physics, const BodyPlan& plan, double degrees,
                       const SceneSettings& settings)
    : angle_(to_radians(degrees)) {
    Environment leaning;
    leaning.gravity_direction = -90.0 - degrees;
    level_ = made(physics, plan, leaning, settings);
    slope_ = made(physics, turned_plan(plan, angle_), sloping_ground(angle_), settings);
    stand_on_ground(*level_);
    slope_->translate(turned_point(level_->center_of_mass(), angle_) - slope_->center_of_mass());
    slope_->restart_audit();
}

double SlopeTwins::apart() const {
    double apart = 0.0;
    for (std::size_t part = 0; part < slope_->part_count(); ++part) {
        const Vec3 twin = turned_point(level_->part_center(part), angle_);
        apart = std::max(apart, (twin - slope_->part_center(part)).norm());
    }
    return apart;
}

SceneSettings with_even_steps(SceneSettings settings) {
    settings.tolerance = 0.1;
    settings.contact_step = 1.0 / 480;
    return settings;
}

}  // namespace cambrian
