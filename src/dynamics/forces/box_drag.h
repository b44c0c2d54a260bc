#pragma once

// Drag of four boxes at once (dynamics/README.md 7). Of two opposite faces of a box exactly one
// leads at every place, and both have the same profile of normal speed. So two line integrals for
// each box suffice. The normal force per length of face is
//     p(u) = -(k1 u + k2 |u| u),
// with u = u_y + spin xi along the long faces and u = u_x - spin eta along the short ones.
// Three-point Gauss-Legendre quadrature is exact where u keeps its sign. The force at each node
// opposes the node's motion, so drag never does positive work.

#include "dynamics/model/forcing.h"
#include "dynamics/model/part_places.h"

namespace cambrian {

// Directions, motions and sizes of four boxes.
struct BoxMotion {
    LanePair axis;                  // unit, along the length
    LanePair velocity;              // m/s
    Lanes spin;                     // rad/s
    Lanes half_length, half_width;  // m
};

struct BoxDrag {
    Lanes force_x, force_y;  // N
    Lanes moment;            // N m, about the box's centre
    Lanes power;             // W, never positive
};

namespace box_drag_detail {

inline constexpr double kNode = 0.7745966692414834;  // sqrt(3/5)
inline constexpr double kEndWeight = 5.0 / 9.0;
inline constexpr double kMiddleWeight = 8.0 / 9.0;

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

}  // namespace box_drag_detail

CAMBRIAN_INLINE BoxDrag drag_boxes(const Medium& medium, const BoxMotion& box) {
    using namespace box_drag_detail;
    const LanePair& axis = box.axis;
    const Lanes along = axis.x * box.velocity.x + axis.y * box.velocity.y;
    const Lanes across = axis.x * box.velocity.y - axis.y * box.velocity.x;
    const FaceDrag sides = integrate_face(medium, across, box.spin, box.half_length);
    const FaceDrag ends = integrate_face(medium, along, -box.spin, box.half_width);
    const Lanes moment = sides.moment - ends.moment;
    return {axis.x * ends.force - axis.y * sides.force, axis.y * ends.force + axis.x * sides.force,
            moment, along * ends.force + across * sides.force + box.spin * moment};
}

}  // namespace cambrian
