#include "render/solid_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cambrian {
namespace {

constexpr int kMostRaySteps = 24;      // of a ray
constexpr int kShadeSteps = 14;        // of a ray towards the light
constexpr double kNearSurface = 4e-4;  // m
constexpr double kHardness = 9.0;      // of the edge of a shadow
constexpr double kAmbient = 0.42;
constexpr double kSunlight = 0.85;
constexpr double kShine = 0.16;
constexpr double kRim = 0.22;

// A solid in the axes that rays are turned into.
struct Body {
    const Solid* solid;
    Vec3 center;
    Rotation back;                     // from the world's axes to the solid's own
    double reach;                      // m, from the centre to a corner
    int low_x, low_y, high_x, high_y;  // of the picture, the last ones excluded
};

double gap_to(const Body& body, const Vec3& point) {
    const Vec3 local = body.back * Vec3(point - body.center);
    const double radius = body.solid->radius;
    const Vec3 out = local.cwiseAbs() - (body.solid->half_extents - Vec3::Constant(radius));
    return out.cwiseMax(0.0).norm() + std::min(out.maxCoeff(), 0.0) - radius;
}

// The outward normal, smooth round the edges.
Vec3 normal_at(const Body& body, const Vec3& point) {
    const Vec3 local = body.back * Vec3(point - body.center);
    const Vec3 inner = body.solid->half_extents - Vec3::Constant(body.solid->radius);
    Vec3 out = (local.cwiseAbs() - inner).cwiseMax(0.0);
    for (int i = 0; i < 3; ++i)
        out[i] = local[i] < 0.0 ? -out[i] : out[i];
    const double length = out.norm();
    if (length < 1e-12) return Vec3::UnitY();
    return body.back.conjugate() * Vec3(out / length);
}

// What a ray meets, or how close it comes to something.
struct Hit {
    const Body* body = nullptr;
    double way = std::numeric_limits<double>::infinity();        // m
    double closeness = std::numeric_limits<double>::infinity();  // least distance over the way
};

// Follows a ray to the surface of one solid.
void follow_ray(const Body& body, const Vec3& eye, const Vec3& direction, Hit& hit) {
    const double middle = (body.center - eye).dot(direction);
    const double aside = ((body.center - eye) - middle * direction).norm();
    if (aside > 1.05 * body.reach || middle < 0.0) return;
    double way = std::max(0.0, middle - 1.05 * body.reach);
    for (int step = 0; step < kMostRaySteps && way < middle + body.reach; ++step) {
        const double gap = gap_to(body, eye + way * direction);
        hit.closeness = std::min(hit.closeness, gap / way);
        if (gap < kNearSurface) {
            if (way < hit.way) {
                hit.way = way;
                hit.body = &body;
            }
            return;
        }
        way += gap;
    }
}

class Painting {
public:
    Painting(const SpaceCamera& camera, const SpaceLight& light, std::span<const Solid> solids)
        : camera_(camera), light_(light), eye_(camera.place()), sun_(light.direction.normalized()) {
        for (const Solid& solid : solids)
            bodies_.push_back(body_of(solid));
    }

    void paint(Image& image, int left, int top) const {
        int low_x = 1 << 20;
        int low_y = 1 << 20;
        int high_x = 0;
        int high_y = 0;
        for (const Body& body : bodies_) {
            low_x = std::min(low_x, body.low_x);
            low_y = std::min(low_y, body.low_y);
            high_x = std::max(high_x, body.high_x);
            high_y = std::max(high_y, body.high_y);
        }
        for (int y = low_y; y < high_y; ++y) {
            if (y + top < 0 || y + top >= image.height) continue;
            for (int x = low_x; x < high_x; ++x) {
                if (x + left >= 0 && x + left < image.width)
                    paint_pixel(image.pixel(x + left, y + top), x, y);
            }
        }
    }

private:
    Body body_of(const Solid& solid) const {
        Body body{&solid,
                  solid.pose.position,
                  solid.pose.orientation.conjugate(),
                  solid.half_extents.norm(),
                  1 << 20,
                  1 << 20,
                  0,
                  0};
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 signs((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1,
                             (corner & 4) != 0 ? 1 : -1);
            const Vec2 at =
                camera_.look_at(transform(solid.pose, signs.cwiseProduct(solid.half_extents)))
                    .place;
            body.low_x = std::min(body.low_x, static_cast<int>(std::floor(at.x())) - 2);
            body.low_y = std::min(body.low_y, static_cast<int>(std::floor(at.y())) - 2);
            body.high_x = std::max(body.high_x, static_cast<int>(std::ceil(at.x())) + 3);
            body.high_y = std::max(body.high_y, static_cast<int>(std::ceil(at.y())) + 3);
        }
        body.low_x = std::max(body.low_x, 0);
        body.low_y = std::max(body.low_y, 0);
        body.high_x = std::min(body.high_x, static_cast<int>(camera_.width));
        body.high_y = std::min(body.high_y, static_cast<int>(camera_.height));
        return body;
    }

    // A ray that misses by less than a pixel covers a part of it, which makes edges smooth.
    void paint_pixel(std::uint8_t* pixel, int x, int y) const {
        const Vec3 direction = camera_.direction(x + 0.5, y + 0.5).normalized();
        Hit hit;
        const Body* closest = nullptr;
        for (const Body& body : bodies_) {
            if (x < body.low_x || x >= body.high_x || y < body.low_y || y >= body.high_y) continue;
            const double before = hit.closeness;
            follow_ray(body, eye_, direction, hit);
            if (hit.closeness < before) closest = &body;
        }
        const double a_pixel = 1.0 / (camera_.pixels_per_metre * camera_.distance());
        double cover = 1.0;
        if (hit.body == nullptr) {
            if (closest == nullptr || hit.closeness > a_pixel) return;
            cover = 1.0 - hit.closeness / a_pixel;
            hit.body = closest;
            hit.way = (closest->center - eye_).dot(direction);
            // The nearest point of the solid's outline, as far as the middle of it tells.
            for (int step = 0; step < 2; ++step)
                hit.way -= gap_to(*closest, eye_ + hit.way * direction);
        }
        const Color color = color_at(*hit.body, direction, hit.way);
        const float share = static_cast<float>(cover);
        const float channels[3] = {color.r, color.g, color.b};
        for (int i = 0; i < 3; ++i) {
            const float under = static_cast<float>(pixel[i]);
            pixel[i] = static_cast<std::uint8_t>(
                std::clamp(under + share * (255.0F * channels[i] - under) + 0.5F, 0.0F, 255.0F));
        }
    }

    // The share of the sun that reaches a point.
    double sunlight(const Vec3& point, const Body& own) const {
        double light = 1.0;
        for (const Body& body : bodies_) {
            if (&body == &own) continue;
            const Vec3 between = body.center - point;
            const double middle = between.dot(sun_);
            const double aside = (between - middle * sun_).norm();
            if (middle < -body.reach || aside > 1.3 * body.reach) continue;
            double way = std::max(0.01, middle - 1.3 * body.reach);
            for (int step = 0; step < kShadeSteps && way < middle + body.reach; ++step) {
                const double gap = gap_to(body, point + way * sun_);
                light = std::min(light, std::max(0.0, kHardness * gap / way));
                if (gap < kNearSurface) break;
                way += std::max(gap, 0.004);
            }
        }
        return light;
    }

    // How open the surroundings of a point are.
    double openness(const Vec3& point, const Vec3& normal, const Body& own) const {
        double open = 1.0;
        for (const double height : {0.04, 0.12}) {
            double gap = height;
            for (const Body& body : bodies_) {
                if (&body != &own) gap = std::min(gap, gap_to(body, point + height * normal));
            }
            open *= 1.0 - 0.45 * (1.0 - std::max(0.0, gap) / height);
        }
        return open;
    }

    Color color_at(const Body& body, const Vec3& direction, double way) const {
        const Vec3 point = eye_ + way * direction;
        const Vec3 normal = normal_at(body, point);
        const double facing = std::max(0.0, normal.dot(sun_));
        const double sun = facing > 0.0 ? facing * sunlight(point + 0.004 * normal, body) : 0.0;
        const double open = openness(point, normal, body);
        const float upward = static_cast<float>(0.5 + 0.5 * normal.y());
        const Color sky = mix(light_.below, light_.above, upward);
        const Vec3 half = (sun_ - direction).normalized();
        const double glance = std::pow(std::max(0.0, normal.dot(half)), 24.0) * sun;
        const double edge = 1.0 - std::max(0.0, -normal.dot(direction));
        const double rim = kRim * edge * edge * edge * (0.7 + 0.3 * normal.y());
        const auto lit = [&](float fill, float around) {
            // Light adds up in squares of the colours' numbers.
            const double base = static_cast<double>(fill) * static_cast<double>(fill);
            const double ambient = static_cast<double>(around) * static_cast<double>(around);
            const double sum = base * (kAmbient * open * (0.35 + ambient) + kSunlight * sun) +
                               kShine * glance + rim * ambient * open;
            return static_cast<float>(std::sqrt(std::clamp(sum, 0.0, 1.0)));
        };
        const Color& fill = body.solid->fill;
        Color color{lit(fill.r, sky.r), lit(fill.g, sky.g), lit(fill.b, sky.b)};
        const double behind = std::max(0.0, way - camera_.distance());
        return mix(color, light_.haze, static_cast<float>(behind / (behind + light_.haze_depth)));
    }

    const SpaceCamera& camera_;
    const SpaceLight& light_;
    Vec3 eye_;
    Vec3 sun_;
    std::vector<Body> bodies_;
};

}  // namespace

void paint_solids(Image& image, int left, int top, const SpaceCamera& camera,
                  const SpaceLight& light, std::span<const Solid> solids) {
    Painting(camera, light, solids).paint(image, left, top);
}

}  // namespace cambrian
