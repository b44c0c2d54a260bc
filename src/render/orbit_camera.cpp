#include "render/orbit_camera.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kTurn = to_radians(0.4);  // a pixel

// Pixels per metre at the target for a camera at 1 m from it.
double pixels_at_a_metre(const Viewport& viewport) {
    const SineCosine half = sine_cosine(SpaceCamera::kHalfView);
    return 0.5 * viewport.height * half.cosine / half.sine;
}

}  // namespace

SpaceCamera OrbitCamera::seen(const Viewport& viewport) const {
    SpaceCamera camera;
    camera.look_from(yaw, pitch);
    camera.target = target;
    camera.pixels_per_metre = pixels_at_a_metre(viewport) / distance;
    camera.width = viewport.width;
    camera.height = viewport.height;
    return camera;
}

void OrbitCamera::orbit(const Vec2& pixels) {
    yaw = wrap_angle(yaw - kTurn * pixels.x());
    pitch = std::clamp(pitch + kTurn * pixels.y(), -kSteepest, kSteepest);
}

void OrbitCamera::pan(const Vec2& pixels, const Viewport& viewport) {
    const SpaceCamera camera = seen(viewport);
    target += (-pixels.x() * camera.right + pixels.y() * camera.up) / camera.pixels_per_metre;
}

void OrbitCamera::zoom_about(const Vec2& cursor, double factor, const Viewport& viewport) {
    const double wanted = std::clamp(distance / factor, kNearest, kFarthest);
    const SpaceCamera camera = seen(viewport);
    const Vec2 away = cursor - 0.5 * Vec2(viewport.width, viewport.height);
    const double share = 1.0 - wanted / distance;
    target += share * (away.x() * camera.right - away.y() * camera.up) / camera.pixels_per_metre;
    distance = wanted;
}

double OrbitCamera::distance_for(std::span<const Vec3> points, double share,
                                 const Viewport& viewport) const {
    const SpaceCamera camera = seen(viewport);
    const double high = 0.5 * viewport.height * share / pixels_at_a_metre(viewport);
    const double wide = high * viewport.width / viewport.height;
    double needed = kNearest;
    for (const Vec3& point : points) {
        const Vec3 from = point - target;
        const double aside = std::max(std::fabs(from.dot(camera.right)) / wide,
                                      std::fabs(from.dot(camera.up)) / high);
        needed = std::max(needed, aside + from.dot(camera.back));
    }
    return needed;
}

void OrbitCamera::fit(std::span<const Vec3> points, double share, const Viewport& viewport) {
    if (points.empty()) return;
    const SpaceCamera camera = seen(viewport);
    Vec3 low = Vec3::Constant(1e9);
    Vec3 high = Vec3::Constant(-1e9);
    for (const Vec3& point : points) {
        const Vec3 seen_at(point.dot(camera.right), point.dot(camera.up), point.dot(camera.back));
        low = low.cwiseMin(seen_at);
        high = high.cwiseMax(seen_at);
    }
    const Vec3 middle = 0.5 * (low + high);
    target = middle.x() * camera.right + middle.y() * camera.up + middle.z() * camera.back;
    distance = std::min(distance_for(points, share, viewport), kFarthest);
}

double OrbitCamera::share_of(std::span<const Vec3> points, const Viewport& viewport) const {
    return distance_for(points, 1.0, viewport) / distance;
}

void OrbitCamera::look_from(const Vec3& side) {
    pitch = std::clamp(std::atan2(side.y(), std::hypot(side.x(), side.z())), -kSteepest, kSteepest);
    if (side.x() != 0.0 || side.z() != 0.0) yaw = std::atan2(side.x(), side.z());
}

void OrbitCamera::approach(const Vec3& point, double elapsed, double lag, double most) {
    target += (point - target) * (1.0 - std::exp(-elapsed / lag));
    const Vec3 behind = point - target;
    const double away = behind.norm();
    if (away > most) target = point - most / away * behind;
}

}  // namespace cambrian
