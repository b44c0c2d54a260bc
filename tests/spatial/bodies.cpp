#include "spatial/bodies.h"

#include "core/assert.h"
#include "math/elementary.h"
#include "spatial/algebra.h"

namespace cambrian {
namespace {

Vec3 random_vector(RandomStream& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

}  // namespace

BodyPlan one_solid(const Vec3& half_extents) {
    BodyPlan plan;
    plan.parts.emplace_back();
    plan.parts.front().half_extents = half_extents;
    return plan;
}

BodyPlan random_solid(RandomStream& random, int parts, double strength) {
    static const JointRegistry joints = spatial_scene_kind().joints;
    const auto half = [&random] {
        // Braces, so that every compiler draws in this order.
        return Vec3{random.uniform(0.1, 0.35), random.uniform(0.04, 0.1),
                    random.uniform(0.04, 0.1)};
    };
    BodyPlan plan = one_solid(half());
    plan.parts.front().rest_pose.orientation = spatial::rotation_by(random_vector(random, 1.5));
    for (int i = 1; i < parts; ++i) {
        const int parent =
            random.chance(1.0 / 3) ? static_cast<int>(random.below(plan.parts.size())) : i - 1;
        const PlannedPart& from = plan.parts[static_cast<std::size_t>(parent)];
        PlannedPart part;
        part.half_extents = half();
        part.parent = parent;
        part.anchor_in_parent =
            Vec3{from.half_extents.x(), random.uniform(-0.9, 0.9) * from.half_extents.y(),
                 random.uniform(-0.9, 0.9) * from.half_extents.z()};
        part.anchor_in_child = Vec3(-part.half_extents.x(), 0.0, 0.0);
        const Rotation turn = spatial::product(from.rest_pose.orientation,
                                               spatial::rotation_by(random_vector(random, 0.7)));
        part.rest_pose = {transform(from.rest_pose, part.anchor_in_parent), turn};
        part.rest_pose.position = transform(part.rest_pose, -part.anchor_in_child);
        const JointKind& joint = joints[random.below(joints.size())];
        part.motion = joint.motion;
        JointGenes genes{
            .limit_low = -random.uniform(0.4, 1.2),
            .limit_high = random.uniform(0.4, 1.2),
            .length = 2.0 * part.half_extents.x(),
            .width = 2.0 * std::fmin(part.half_extents.y(), from.half_extents.y()),
            .mirror = {.across = random.chance(0.5) ? 1 : -1, .depth = random.chance(0.5) ? 1 : -1},
            .muscle_strength = strength};
        genes.depth = 2.0 * std::fmin(part.half_extents.z(), from.half_extents.z());
        for (auto& limits : genes.further_limits)
            limits = {-random.uniform(0.4, 1.2), random.uniform(0.4, 1.2)};
        if (joint.shape != nullptr) joint.shape(genes, part);
        plan.parts.push_back(part);
    }
    return plan;
}

BodyPlan with_depth(BodyPlan plan, double depth) {
    for (PlannedPart& part : plan.parts)
        part.half_extents.z() = 0.5 * depth;
    return plan;
}

BodyPlan turned_plan(BodyPlan plan, const Rotation& turn) {
    for (PlannedPart& part : plan.parts) {
        part.rest_pose.position = turn * part.rest_pose.position;
        part.rest_pose.orientation = spatial::product(turn, part.rest_pose.orientation);
    }
    return plan;
}

Environment weightless() {
    Environment environment;
    environment.dimensions = 3;
    environment.gravity = 0.0;
    environment.has_ground = false;
    environment.density = 1000.0;
    return environment;
}

Environment spatial_water() {
    Environment environment = weightless();
    environment.viscosity_linear = 200.0;
    environment.viscosity_quadratic = 1000.0;
    return environment;
}

Environment spatial_ground(double friction, double elasticity) {
    Environment environment = weightless();
    environment.gravity = kEarthGravity;
    environment.has_ground = true;
    environment.friction = friction;
    environment.elasticity = elasticity;
    return environment;
}

std::unique_ptr<PhysicsScene> make_solid(const BodyPlan& plan, const Environment& environment,
                                         const SceneSettings& settings) {
    auto scene = spatial_scene_kind().make(plan, environment, settings);
    CAMBRIAN_ASSERT(scene.has_value(), "bodies of tests are valid");
    return *std::move(scene);
}

void swing(PhysicsScene& scene, const BodyPlan& plan, double fastest) {
    for (std::size_t part = 1; part < plan.parts.size(); ++part) {
        for (std::size_t d = 0; d < degrees_of(plan.parts[part]); ++d) {
            const double number = static_cast<double>(3 * part + d);
            const double frequency = fastest * (0.3 + 0.7 * number / (number + 5.0));
            const DegreeLimits limits = limits_of(plan.parts[part], d);
            scene.set_target(
                JointDegree{static_cast<std::uint16_t>(part), static_cast<std::uint8_t>(d)},
                std::fmin(limits.high, -limits.low) *
                    sine(2.0 * kPi * frequency * scene.time() + number));
        }
    }
}

void run_ticks(PhysicsScene& scene, int ticks) {
    for (int tick = 0; tick < ticks; ++tick)
        CAMBRIAN_ASSERT(scene.advance(1.0 / 60) == SceneStatus::kRunning, "must succeed");
}

void stand(PhysicsScene& scene) {
    const Vec3 center = scene.center_of_mass();
    scene.translate({-center.x(), 0.02 - scene.lowest_point(), -center.z()});
}

void begin_box(PhysicsScene& scene, const SolidMotion& box) {
    const Vec3 half = scene.part_half_extents(0);
    const Vec3 squares = half.cwiseProduct(half);
    const Vec3 inertia =
        scene.mass() / 3.0 *
        Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
    const Rotation& q = box.attitude;
    const Vec3 momentum = q * inertia.cwiseProduct(q.conjugate() * box.spin);
    const bool begun =
        scene.begin_at({{q.w(), q.x(), q.y(), q.z(), box.place.x(), box.place.y(), box.place.z()},
                        {momentum.x(), momentum.y(), momentum.z(), box.velocity.x(),
                         box.velocity.y(), box.velocity.z()},
                        {}});
    CAMBRIAN_ASSERT(begun, "a box may begin anywhere");
}

Vec3 angular_momentum(const PhysicsScene& scene, double density) {
    Vec3 momentum = Vec3::Zero();
    for (std::size_t p = 0; p < scene.part_count(); ++p) {
        const Vec3 half = scene.part_half_extents(p);
        const double mass = 8.0 * density * half.x() * half.y() * half.z();
        const Vec3 squares = half.cwiseProduct(half);
        const Vec3 inertia =
            mass / 3.0 *
            Vec3(squares.y() + squares.z(), squares.x() + squares.z(), squares.x() + squares.y());
        const Twist twist = scene.part_twist(p);
        const Rotation turn = scene.part_pose(p).orientation;
        momentum += turn * inertia.cwiseProduct(turn.conjugate() * twist.angular) +
                    mass * (scene.part_center(p) - scene.center_of_mass()).cross(twist.linear);
    }
    return momentum;
}

}  // namespace cambrian
