#include "bench/drag_law.h"

#include <cmath>

namespace cambrian::bench {
namespace {

// Integrals over a face [-half, half] of the normal pressure and of its moment, by three-point
// Gauss-Legendre quadrature. The normal speed at a station is speed + slope * station.
struct FaceLoad {
    double force;
    double moment;
};

FaceLoad integrate_face(double speed, double slope, double half, const Environment& medium) {
    constexpr double nodes[] = {-0.7745966692414834, 0.0, 0.7745966692414834};
    constexpr double weights[] = {5.0 / 9, 8.0 / 9, 5.0 / 9};
    FaceLoad load{0.0, 0.0};
    for (int i = 0; i < 3; ++i) {
        const double station = half * nodes[i];
        const double u = speed + slope * station;
        const double pressure =
            -(medium.viscosity_linear + medium.viscosity_quadratic * std::fabs(u)) * u;
        load.force += half * weights[i] * pressure;
        load.moment += half * weights[i] * pressure * station;
    }
    return load;
}

}  // namespace

PlanarWrench drag_on(const PartMotion& part, const Vec3& half_extents,
                     const Environment& environment) {
    const double cosine = std::cos(part.angle);
    const double sine = std::sin(part.angle);
    const double along = cosine * part.velocity_x + sine * part.velocity_y;
    const double across = cosine * part.velocity_y - sine * part.velocity_x;
    const FaceLoad sides = integrate_face(across, part.spin, half_extents.x(), environment);
    const FaceLoad ends = integrate_face(along, -part.spin, half_extents.y(), environment);
    return {cosine * ends.force - sine * sides.force, sine * ends.force + cosine * sides.force,
            sides.moment - ends.moment};
}

}  // namespace cambrian::bench
