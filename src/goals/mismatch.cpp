#include "goals/mismatch.h"

#include "math/angle.h"
#include "math/elementary.h"

namespace cambrian {
namespace {

constexpr double kThinnest = 1e-3;  // least viscosity, of either kind, that allows swimming

double pull_down(const Environment& environment) {
    return -environment.gravity * sine(to_radians(environment.gravity_direction));
}

bool is_thin(const Environment& environment) {
    return environment.viscosity_linear < kThinnest && environment.viscosity_quadratic < kThinnest;
}

std::string needs_hold(const Environment& environment) {
    if (!environment.has_ground && is_thin(environment))
        return "there is neither ground nor a medium to push off from";
    return {};
}

}  // namespace

std::string needs_ground(const Environment& environment) {
    if (!environment.has_ground) return "there is no ground";
    if (!(pull_down(environment) > 0.0)) return "nothing pulls creatures to the ground";
    return {};
}

std::string needs_level_ground(const Environment& environment) {
    std::string missing = needs_ground(environment);
    if (!missing.empty()) return missing;
    if (sine_cosine_of_degrees(environment.gravity_direction).cosine != 0.0)
        return "the ground slopes, which favors one side";
    return {};
}

std::string needs_shaped_ground(const Environment& environment) {
    if (environment.terrain.is_flat()) return "the ground is flat";
    return needs_level_ground(environment);
}

std::string needs_course(const Environment& environment) {
    if (environment.terrain.kind != "course") return "the ground is no obstacle course";
    return needs_level_ground(environment);
}

std::string needs_air(const Environment& environment) {
    if (!(pull_down(environment) > 0.0)) return "nothing pulls creatures down";
    if (is_thin(environment)) return "the medium is too thin to carry anything";
    if (environment.has_ground)
        return "creatures begin on the ground, and touching it ends a flight";
    return {};
}

std::string needs_jumping_light(const Environment& environment) {
    if (environment.light_motion != "jumping") return "the light does not jump";
    return needs_hold(environment);
}

std::string needs_hunting_light(const Environment& environment) {
    if (environment.light_motion != "hunting") return "the light does not hunt";
    return needs_hold(environment);
}

std::string needs_wall(const Environment& environment) {
    if (!environment.has_wall) return "there is no wall to get away from";
    return needs_level_ground(environment);
}

std::string needs_water(const Environment& environment) {
    if (is_thin(environment)) return "the medium has no viscosity to push off from";
    if (environment.has_ground) return "there is ground to crawl on";
    if (environment.gravity > 0.0) return "gravity makes creatures fall instead";
    return {};
}

}  // namespace cambrian
