#include "simulator/surroundings/light_source.h"

#include "math/elementary.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kHeight = 0.3;            // body lengths, above ground
constexpr double kDark = 1e-6;             // intensity below which there is no direction
constexpr double kSlowing = 0.5;           // 1/s, damping of a wandering light
constexpr double kNoise = 0.6;             // m/s^1.5, noise of a wandering light
constexpr std::uint64_t kWandering = ~0U;  // stream of the noise, not the number of a leg

Vec3 start_of(const Environment& environment) {
    return {environment.light_x, environment.light_y, 0.0};
}

std::uint64_t leg_seed(const LightDraw& draw, std::uint64_t leg) {
    return stream_seed({draw.seed, static_cast<std::uint64_t>(Purpose::kLight),
                        static_cast<std::uint64_t>(draw.trial / 2), leg});
}

// Returns 1, or -1 for a trial that mirrors the one before it.
double side_of(const LightDraw& draw) {
    return draw.trial % 2 == 0 ? 1.0 : -1.0;
}

// Reflects a position and its velocity at the edges of a range.
void reflect(double& place, double& velocity, double low, double high) {
    if (place < low) {
        place = std::min(2.0 * low - place, high);
        velocity = std::fabs(velocity);
    } else if (place > high) {
        place = std::max(2.0 * high - place, low);
        velocity = -std::fabs(velocity);
    }
}

}  // namespace

LightSource::LightSource(const Environment& environment, const LightDraw& draw)
    : environment_(environment),
      draw_(draw),
      moment_{.place = start_of(environment), .noise = RandomStream(leg_seed(draw, kWandering))} {}

void LightSource::set_environment(const Environment& environment) {
    const bool moved = environment.light_x != environment_.light_x ||
                       environment.light_y != environment_.light_y ||
                       environment.light_motion != environment_.light_motion;
    environment_ = environment;
    if (!moved) return;
    moment_.place = start_of(environment);
    moment_.velocity = Vec3::Zero();
}

bool LightSource::moves() const {
    return is_on() && environment_.light_motion != "still";
}

void LightSource::move(std::uint64_t tick, const Vec3& center, double length) {
    if (!moves()) return;
    if (environment_.light_motion == "wandering") {
        wander();
    } else if (tick % leg_ticks() == 0) {
        jump(tick / leg_ticks(), center, length);
    } else if (environment_.light_motion == "hunting") {
        follow(center);
    }
}

std::uint64_t LightSource::leg_ticks() const {
    const double ticks = environment_.light_period / kBrainTick + 0.5;
    return static_cast<std::uint64_t>(std::max(1.0, ticks));
}

// Moves the light to the left or right above ground, or in any direction without ground.
void LightSource::jump(std::uint64_t leg, const Vec3& center, double length) {
    RandomStream stream(leg_seed(draw_, leg));
    const double distance =
        length * stream.uniform(environment_.light_nearest, environment_.light_farthest);
    moment_.distance = distance;
    if (environment_.has_ground) {
        const double side = stream.chance(0.5) ? side_of(draw_) : -side_of(draw_);
        moment_.place = {center.x() + side * distance, kHeight * length, 0.0};
    } else {
        const SineCosine way = sine_cosine(stream.uniform(-kPi, kPi));
        moment_.place = center + distance * Vec3(side_of(draw_) * way.cosine, way.sine, 0.0);
    }
}

// Lets a light that hunts follow a creature that flees, so that it stays where it was seen.
void LightSource::follow(const Vec3& center) {
    Vec3 way = moment_.place - center;
    if (environment_.has_ground) way.y() = 0.0;
    const double distance = way.norm();
    if (distance > moment_.distance) moment_.place -= (1.0 - moment_.distance / distance) * way;
}

// Integrates v' = -v / (2 s) + noise. The light is reflected at a box around its start and at the
// ground.
void LightSource::wander() {
    const double share = kNoise * std::sqrt(kBrainTick);
    const double across = side_of(draw_) * share * moment_.noise.gauss();
    const double upwards = share * moment_.noise.gauss();
    moment_.velocity += Vec3(across, upwards, 0.0) - kSlowing * kBrainTick * moment_.velocity;
    moment_.place += kBrainTick * moment_.velocity;
    const Vec3 start = start_of(environment_);
    const double range = environment_.light_range;
    const double lowest =
        environment_.has_ground ? std::max(0.0, start.y() - range) : start.y() - range;
    reflect(moment_.place.x(), moment_.velocity.x(), start.x() - range, start.x() + range);
    reflect(moment_.place.y(), moment_.velocity.y(), lowest, std::max(lowest, start.y() + range));
}

Light LightSource::at(const Vec3& point) const {
    if (!is_on()) return {};
    const Vec3 way = moment_.place - point;
    const double square = way.squaredNorm();
    const double reach = environment_.light_reach;
    const double intensity = environment_.light_brightness / (1.0 + square / (reach * reach));
    if (!(intensity >= kDark && square > 0.0)) return {.intensity = intensity};
    return {way / std::sqrt(square), intensity};
}

}  // namespace cambrian
