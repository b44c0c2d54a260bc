#include "render/space_seen.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kNearest = 0.04;  // of the target's distance
constexpr double kFarPlane = 400.0;

}  // namespace

SpacePainter::Seen::Seen(const SpaceFrame& frame, const PixelRect& target)
    : camera(frame.camera), sun(frame.light.direction.normalized()) {
    width = target.width * frame.samples;
    height = target.height * frame.samples;
    camera.width = width;
    camera.height = height;
    camera.pixels_per_metre *= frame.samples;
    eye = camera.distance() * camera.back;
    const double near = kNearest * camera.distance();
    const double far = kFarPlane * camera.distance();
    const double focal = 2.0 * camera.pixels_per_metre * camera.distance();
    const Vec3 x = focal / width * camera.right;
    const Vec3 y = focal / height * camera.up;
    const double steep = (far + near) / (far - near);
    for (int k = 0; k < 3; ++k) {
        const auto column = 4 * static_cast<std::size_t>(k);
        view[column] = static_cast<float>(x[k]);
        view[column + 1] = static_cast<float>(y[k]);
        view[column + 2] = static_cast<float>(-steep * camera.back[k]);
        view[column + 3] = static_cast<float>(-camera.back[k]);
    }
    view[12] = 0.0F;
    view[13] = 0.0F;
    view[14] = static_cast<float>(steep * camera.distance() - 2.0 * far * near / (far - near));
    view[15] = static_cast<float>(camera.distance());
}

int SpacePainter::Seen::rows_of_floor(const SpaceFloor* floor, const Vec3& target) const {
    const double rise = camera.back.y();
    const double over_floor = floor != nullptr ? eye.y() - floor->height + target.y() : 0.0;
    if (over_floor <= 0.0 || std::fabs(rise) >= 0.9) return 0;
    const double focal = camera.pixels_per_metre * camera.distance();
    const double level = std::sqrt(1.0 - rise * rise);
    const double horizon = 0.5 * height + focal * rise / level;
    // The floor ends a little below the horizon.
    const double gap = focal * over_floor / (kFloorReach * camera.distance());
    return static_cast<int>(
        std::clamp(horizon - 4.0 - 2.0 * gap / (level * level), 0.0, 1.0 * height));
}

}  // namespace cambrian
