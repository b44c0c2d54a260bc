#include "pictures/scene/hunter.h"

#include <cmath>

namespace cambrian {
namespace {

// Lengths are in m.
constexpr double kHunterBody = 0.21;  // radius
constexpr double kHunterEye = 0.055;
constexpr double kHunterPupil = 0.024;
constexpr int kHunterRags = 5;  // of its lower edge
const Color kHunterShade = color_of(0x16111F);
const Color kHunterRim = color_of(0x4A2F2A);
const Color kHunterEyes = color_of(0xFFB23E);

void add_shade(SceneFrame& frame, const Vec2& middle, double size, double time,
               const Color& color) {
    frame.add_circle(middle, size, color);
    for (int i = 0; i < kHunterRags; ++i) {
        const double aside = 2.0 * i / (kHunterRags - 1) - 1.0;
        const double sway = 0.02 * std::sin(4.0 * time + 1.7 * i);
        const double depth = 0.75 + (i % 2 == 0 ? 0.35 : 0.10);
        frame.add_line(middle + size * Vec2(0.72 * aside, -0.2),
                       middle + Vec2(0.85 * size * aside + sway, -depth * size), 0.42 * size,
                       color);
    }
    for (const double side : {-1.0, 1.0})
        frame.add_line(middle + size * Vec2(0.45 * side, 0.6),
                       middle + size * Vec2(0.95 * side, 1.25), 0.22 * size, color);
}

}  // namespace

void add_hunter(SceneFrame& frame, const Vec2& place, const Vec2& prey, double time) {
    const Vec2 middle = place + Vec2(0.0, 0.03 * std::sin(2.3 * time));
    add_shade(frame, middle, 1.12 * kHunterBody, time, kHunterRim);
    add_shade(frame, middle, kHunterBody, time, kHunterShade);
    const Vec2 look = (prey - place).normalized();
    const Vec2 face = middle + 0.30 * kHunterBody * look;
    for (const double side : {-1.0, 1.0}) {
        const Vec2 eye = face + kHunterBody * Vec2(0.40 * side, 0.15);
        frame.add_glow(eye, 3.0 * kHunterEye, with_alpha(kHunterEyes, 0.5F));
        frame.add_circle(eye, kHunterEye, kHunterEyes);
        frame.add_circle(eye + 0.45 * kHunterEye * look, kHunterPupil, kHunterShade);
    }
}

}  // namespace cambrian
