#include "render/camera.h"

#include <algorithm>
#include <cmath>

namespace cambrian {

Vec2 Camera::to_screen(const Vec2& world, const Viewport& viewport) const {
    return {0.5 * viewport.width + (world.x() - center.x()) * pixels_per_metre,
            0.5 * viewport.height - (world.y() - center.y()) * pixels_per_metre};
}

Vec2 Camera::to_world(const Vec2& screen, const Viewport& viewport) const {
    return {center.x() + (screen.x() - 0.5 * viewport.width) / pixels_per_metre,
            center.y() - (screen.y() - 0.5 * viewport.height) / pixels_per_metre};
}

WorldWindow Camera::window(const Viewport& viewport) const {
    return {to_world({0.0, viewport.height}, viewport), to_world({viewport.width, 0.0}, viewport)};
}

void Camera::zoom_about(const Vec2& cursor, double factor, const Viewport& viewport) {
    const Vec2 anchor = to_world(cursor, viewport);
    pixels_per_metre = std::clamp(pixels_per_metre * factor, kMinScale, kMaxScale);
    center += anchor - to_world(cursor, viewport);
}

void Camera::pan(const Vec2& pixels) {
    center += Vec2(-pixels.x(), pixels.y()) / pixels_per_metre;
}

void Camera::fit(const WorldWindow& target, double share, const Viewport& viewport) {
    const Vec2 size = (target.high - target.low).cwiseMax(Vec2::Constant(0.01));
    center = 0.5 * (target.low + target.high);
    const double scale = share * std::min(viewport.width / size.x(), viewport.height / size.y());
    pixels_per_metre = std::clamp(scale, kMinScale, kMaxScale);
}

void Camera::keep_in_view(const WorldWindow& target, double margin, const Viewport& viewport) {
    const Vec2 half = (0.5 - margin) * pixel() * Vec2(viewport.width, viewport.height);
    const Vec2 least = target.high - half;  // of the centre
    const Vec2 most = target.low + half;
    for (int axis = 0; axis < 2; ++axis) {
        center[axis] = least[axis] <= most[axis] ? std::clamp(center[axis], least[axis], most[axis])
                                                 : 0.5 * (target.low[axis] + target.high[axis]);
    }
}

void Camera::approach(const Vec2& target, double elapsed, double lag) {
    center += (target - center) * (1.0 - std::exp(-elapsed / lag));
}

}  // namespace cambrian
