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

void OrbitCamera::fit(const Vec3& middle, double radius, double share, const Viewport& viewport) {
    target = middle;
    const double pixels = 0.5 * share * std::min(viewport.width, viewport.height);
    distance = std::clamp(radius * pixels_at_a_metre(viewport) / std::max(pixels, 1.0), kNearest,
                          kFarthest);
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
