// Of two opposite faces of a box exactly one leads at every station, and both see the same profile
// of normal speed, so two line integrals a box suffice. Normal force a length of face:
//     p(u) = -(k1 u + k2 |u| u),
// u = u_y + spin xi along the long faces, u = u_x - spin eta along the short ones; three-point
// Gauss-Legendre each, which is exact where u keeps its sign. Every node's force opposes its own
// motion, so drag never does positive work.

#include "dynamics/drag.h"

#include "dynamics/part_places.h"

namespace cambrian {
namespace {

constexpr double kNode = 0.7745966692414834;  // sqrt(3/5)
constexpr double kEndWeight = 5.0 / 9.0;
constexpr double kMiddleWeight = 8.0 / 9.0;

struct FaceDrag {
    Lanes force;   // N along the normal
    Lanes moment;  // N m, first moment of the pressure along the face
};

CAMBRIAN_INLINE Lanes pressure(const Medium& medium, const Lanes& u) {
    return -(medium.drag_linear + medium.drag_quadratic * magnitude(u)) * u;
}

// Normal speed at the middle, its slope along the face, and the face's half extent.
CAMBRIAN_INLINE FaceDrag integrate_face(const Medium& medium, const Lanes& u, const Lanes& slope,
                                        const Lanes& half) {
    const Lanes reach = slope * kNode * half;
    const Lanes low = kEndWeight * pressure(medium, u - reach);
    const Lanes high = kEndWeight * pressure(medium, u + reach);
    const Lanes middle = kMiddleWeight * pressure(medium, u);
    return {half * (low + middle + high), half * half * kNode * (high - low)};
}

// Forces on four boxes, as loads of their bodies.
struct PartDrag {
    Lanes force_x, force_y, torque;
    Lanes power;
};

CAMBRIAN_INLINE PartDrag drag_parts(const PlanarModel& model, const Medium& medium,
                                    const Kinematics& k, int first) {
    const PartLanes parts = part_lanes(model, k, first);
    const LanePair axis = part_axes(model, parts, first);
    const LanePair velocity = part_velocities(model, k, parts, first);
    const Lanes spin = gather(k.spin, model.part_body + first);
    const Lanes along = axis.x * velocity.x + axis.y * velocity.y;
    const Lanes across = axis.x * velocity.y - axis.y * velocity.x;
    const FaceDrag sides =
        integrate_face(medium, across, spin, load_lanes(model.half_length + first));
    const FaceDrag ends =
        integrate_face(medium, along, -spin, load_lanes(model.half_width + first));
    PartDrag drag;
    drag.force_x = axis.x * ends.force - axis.y * sides.force;
    drag.force_y = axis.y * ends.force + axis.x * sides.force;
    const Lanes moment = sides.moment - ends.moment;
    drag.torque = moment + parts.arm.x * drag.force_y - parts.arm.y * drag.force_x;
    drag.power = along * ends.force + across * sides.force + spin * moment;
    return drag;
}

}  // namespace

double add_drag(const PlanarModel& model, const Medium& medium, const Kinematics& k, Loads& loads) {
    Lanes power = {};
    for (int first = 0; first < model.part_count; first += kLanes) {
        const PartDrag drag = drag_parts(model, medium, k, first);
        power += drag.power;
        const int end = first + kLanes < model.part_count ? kLanes : model.part_count - first;
        for (int lane = 0; lane < end; ++lane) {
            const int b = model.part_body[first + lane];
            loads.force_x[b] += drag.force_x[lane];
            loads.force_y[b] += drag.force_y[lane];
            loads.torque[b] += drag.torque[lane];
        }
    }
    return sum_of(power);
}

}  // namespace cambrian
