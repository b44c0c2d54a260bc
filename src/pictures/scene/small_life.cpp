#include "pictures/scene/small_life.h"

#include "pictures/scene/character.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kDusty = 0.55;  // share of slips that raise dust
constexpr double kBubbly = 0.12;

void add_dust(SceneFrame& frame, std::span<const Scuff> scuffs, double time, const Color& color) {
    for (const Scuff& scuff : scuffs) {
        const auto luck = [&](std::uint64_t purpose) { return chance(scuff.seed, purpose); };
        if (luck(1) > kDusty) continue;
        const double age = std::clamp((time - scuff.time) / kScuffLife, 0.0, 1.0);
        const double strength = std::min(1.0, scuff.velocity.norm() / 1.6);
        const double left = (1.0 - age) * (1.0 - age);
        const Vec2 at = scuff.place + Vec2(scuff.velocity.x() * 0.16 * age * (0.4 + luck(3)) +
                                               0.08 * (luck(4) - 0.5),
                                           0.015 + age * (0.10 + 0.22 * luck(2)) * strength);
        const double radius = (0.02 + 0.07 * age * strength) * (0.6 + 0.8 * luck(5));
        frame.add_glow(at, radius, with_alpha(color, static_cast<float>(0.6 * strength * left)));
    }
}

void add_wake(SceneFrame& frame, std::span<const Scuff> scuffs, double time, const Color& color,
              bool in_water) {
    for (const Scuff& scuff : scuffs) {
        const auto luck = [&](std::uint64_t purpose) { return chance(scuff.seed, purpose); };
        const double age = std::clamp((time - scuff.time) / kScuffLife, 0.0, 1.0);
        const double left = (1.0 - age) * (1.0 - age);
        const double strength = std::min(1.0, scuff.velocity.norm() / 2.2);
        const Vec2 at = scuff.place + 0.10 * age * Vec2(luck(1) - 0.5, luck(2) - 0.2);
        frame.add_glow(at, 0.012 + 0.045 * age,
                       with_alpha(color, static_cast<float>(0.22 * strength * left)));
        if (!in_water || luck(3) > kBubbly) continue;
        const double bubble = 0.008 + 0.012 * luck(4);
        frame.add_ring(at + Vec2(0.03 * (luck(5) - 0.5), 0.12 * age), bubble, 0.3 * bubble,
                       with_alpha(color_of(0xE8FFFC), static_cast<float>(0.6 * (1.0 - age))));
    }
}

// Returns the colour of dust: of soil, snow or the Moon.
Color dust_of(const Environment& environment) {
    constexpr double kSlippery = 0.2;  // friction
    constexpr double kWeak = 3.0;      // m/s^2, gravity
    if (environment.friction < kSlippery) return color_of(0xE4F2FA);
    return color_of(environment.gravity < kWeak ? 0xB9B9BE : 0xCDB48A);
}

}  // namespace

void add_small_life(SceneFrame& frame, std::span<const Scuff> scuffs, double time,
                    const Environment& environment) {
    constexpr double kThick = 0.5;  // kg/m^2, quadratic drag; thinner fluids are air
    const std::span<const Scuff> seen = scuffs_seen(scuffs, time);
    if (environment.has_ground) {
        add_dust(frame, seen, time, dust_of(environment));
    } else if (environment.viscosity_quadratic >= kThick) {
        add_wake(frame, seen, time, color_of(0xBFE9EE), true);
    } else if (environment.viscosity_quadratic > 0.0) {
        add_wake(frame, seen, time, color_of(0xFFFFFF), false);
    }
}

}  // namespace cambrian
