#include "planar/bodies.h"

#include "core/assert.h"

#include <cmath>

namespace cambrian {

std::unique_ptr<PhysicsScene> make_scene(const BodyPlan& plan, const Environment& environment,
                                         const SceneSettings& settings) {
    auto scene = planar_scene_kind().make(plan, environment, settings);
    CAMBRIAN_ASSERT(scene.has_value(), "physics takes the bodies of tests");
    return std::move(*scene);
}

AngularMomentum angular_momentum_of(const PhysicsScene& scene, double density) {
    AngularMomentum momentum;
    const Vec3 center = scene.center_of_mass();
    const Vec3 velocity = scene.center_of_mass_velocity();
    for (std::size_t part = 0; part < scene.part_count(); ++part) {
        const Vec3 half = scene.part_half_extents(part);
        const double mass = 4.0 * density * half.x() * half.y();
        const Twist twist = scene.part_twist(part);
        const double orbital =
            mass * (scene.part_center(part) - center).cross(twist.linear - velocity).z();
        const double spin = mass * half.head<2>().squaredNorm() / 3.0 * twist.angular.z();
        momentum.sum += orbital + spin;
        momentum.gross += std::fabs(orbital) + std::fabs(spin);
    }
    return momentum;
}

}  // namespace cambrian
