#include "goals/mismatch.h"

#include "math/angle.h"
#include "math/elementary.h"

namespace cambrian {
namespace {

constexpr double kThinnest = 1e-3;  // least viscosity, of either kind, that allows swimming

double pull_down(const Environment& environment) {
    return -environment.gravity * sine(to_radians(environment.gravity_direction));
}

}  // namespace

std::string needs_ground(const Environment& environment) {
    if (!environment.has_ground) return "there is no ground";
    if (!(pull_down(environment) > 0.0)) return "nothing pulls creatures to the ground";
    return {};
}

std::string needs_water(const Environment& environment) {
    const bool thin =
        environment.viscosity_linear < kThinnest && environment.viscosity_quadratic < kThinnest;
    if (thin) return "the medium has no viscosity to push off from";
    if (environment.has_ground) return "there is ground to crawl on";
    if (environment.gravity > 0.0) return "gravity makes creatures fall instead";
    return {};
}

}  // namespace cambrian
