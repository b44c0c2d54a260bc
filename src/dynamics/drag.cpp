// Of two opposite faces of a box exactly one leads at every station, and both see the same profile
// of normal speed, so two line integrals a box suffice. Normal force a length of face:
//     p(u) = -(k1 u + k2 |u| u),
// u = u_y + spin xi along the long faces, u = u_x - spin eta along the short ones; three-point
// Gauss-Legendre each, which is exact where u keeps its sign. Every node's force opposes its own
// motion, so drag never does positive work.

#include "dynamics/drag.h"

#include <cmath>

namespace cambrian {
namespace {

constexpr double kNode = 0.7745966692414834;  // sqrt(3/5)
constexpr double kEndWeight = 5.0 / 9.0;
constexpr double kMiddleWeight = 8.0 / 9.0;

struct FaceDrag {
    double force;   // N along the normal
    double moment;  // N m, first moment of the pressure along the face
};

inline double pressure(const Medium& medium, double u) {
    return -(medium.drag_linear + medium.drag_quadratic * std::fabs(u)) * u;
}

// Normal speed at the middle, its slope along the face, and the face's half extent.
inline FaceDrag integrate_face(const Medium& medium, double u, double slope, double half) {
    const double low = kEndWeight * pressure(medium, u - slope * kNode * half);
    const double high = kEndWeight * pressure(medium, u + slope * kNode * half);
    const double middle = kMiddleWeight * pressure(medium, u);
    return {half * (low + middle + high), half * half * kNode * (high - low)};
}

}  // namespace

double add_drag(const PlanarModel& model, const Medium& medium, const Kinematics& k, Loads& loads) {
    double power = 0.0;
    for (int part = 0; part < model.part_count; ++part) {
        const int b = model.part_body[part];
        const double cosine = k.cosine[b];
        const double sine = k.sine[b];
        const double arm_x = cosine * model.part_x[part] - sine * model.part_y[part];
        const double arm_y = sine * model.part_x[part] + cosine * model.part_y[part];
        const double axis_x = cosine * model.part_cosine[part] - sine * model.part_sine[part];
        const double axis_y = sine * model.part_cosine[part] + cosine * model.part_sine[part];
        const double spin = k.spin[b];
        const double velocity_x = k.velocity_x[b] - spin * arm_y;
        const double velocity_y = k.velocity_y[b] + spin * arm_x;
        const double along = axis_x * velocity_x + axis_y * velocity_y;
        const double across = axis_x * velocity_y - axis_y * velocity_x;
        const FaceDrag sides = integrate_face(medium, across, spin, model.half_length[part]);
        const FaceDrag ends = integrate_face(medium, along, -spin, model.half_width[part]);
        const double force_x = axis_x * ends.force - axis_y * sides.force;
        const double force_y = axis_y * ends.force + axis_x * sides.force;
        const double moment = sides.moment - ends.moment;
        loads.force_x[b] += force_x;
        loads.force_y[b] += force_y;
        loads.torque[b] += moment + arm_x * force_y - arm_y * force_x;
        power += along * ends.force + across * sides.force + spin * moment;
    }
    return power;
}

}  // namespace cambrian
