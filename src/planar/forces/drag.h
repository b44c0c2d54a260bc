#pragma once

// Drag of the medium on the faces of the boxes (planar/README.md 7).

#include "planar/articulated/articulated_body.h"
#include "planar/model/kinematics.h"
#include "planar/model/planar_model.h"

namespace cambrian {

// Adds the drag to the loads and returns its power, W (never positive).
double add_drag(const PlanarModel& model, const Medium& medium, const Kinematics& kinematics,
                Loads& loads);

// Drag of four boxes at once (planar/README.md 7). At each point exactly one of two opposite
// faces moves against the medium, and both have the same profile of normal speed. So two line
// integrals per box suffice. The normal force per length of face is
//     p(u) = -(k1 u + k2 |u| u),
// with u = u_y + spin xi along the long faces and u = u_x - spin eta along the short ones.
// Three-point Gauss-Legendre quadrature is exact where u keeps its sign. The force at each node
// opposes the node's motion, so drag never does positive work.

// Directions, motions and sizes of four boxes.
struct BoxMotion {
    Simd4dVector axis;               // unit, along the length
    Simd4dVector velocity;           // m/s
    Simd4d spin;                     // rad/s
    Simd4d half_length, half_width;  // m
};

struct BoxDrag {
    Simd4d force_x, force_y;  // N
    Simd4d moment;            // N m, about the box's centre
    Simd4d power;             // W, never positive
};

namespace box_drag_detail {

inline constexpr double kNode = 0.7745966692414834;  // sqrt(3/5)
inline constexpr double kEndWeight = 5.0 / 9.0;
inline constexpr double kMiddleWeight = 8.0 / 9.0;

struct FaceDrag {
    Simd4d force;   // N along the normal
    Simd4d moment;  // N m, first moment of the pressure along the face
};

CAMBRIAN_INLINE Simd4d pressure(const Medium& medium, const Simd4d& u) {
    return (-medium.drag_linear + -medium.drag_quadratic * magnitude(u)) * u;
}

// Normal speed at the middle, its slope along the face, and the face's half extent.
CAMBRIAN_INLINE FaceDrag integrate_face(const Medium& medium, const Simd4d& u, const Simd4d& slope,
                                        const Simd4d& half) {
    const Simd4d reach = slope * kNode * half;
    const Simd4d low = kEndWeight * pressure(medium, u - reach);
    const Simd4d high = kEndWeight * pressure(medium, u + reach);
    const Simd4d middle = kMiddleWeight * pressure(medium, u);
    return {half * (low + middle + high), half * half * kNode * (high - low)};
}

}  // namespace box_drag_detail

CAMBRIAN_INLINE BoxDrag drag_boxes(const Medium& medium, const BoxMotion& box) {
    using namespace box_drag_detail;
    const Simd4dVector& axis = box.axis;
    const Simd4d along = axis.x * box.velocity.x + axis.y * box.velocity.y;
    const Simd4d across = axis.x * box.velocity.y - axis.y * box.velocity.x;
    const FaceDrag sides = integrate_face(medium, across, box.spin, box.half_length);
    const FaceDrag ends = integrate_face(medium, along, -box.spin, box.half_width);
    const Simd4d moment = sides.moment - ends.moment;
    return {axis.x * ends.force - axis.y * sides.force, axis.y * ends.force + axis.x * sides.force,
            moment, along * ends.force + across * sides.force + box.spin * moment};
}

// Drag of models with stretches (planar/README.md 20). Opposite faces of a part that stretches do
// not see the same speed, so all four are integrated; where a face leads, its outward normal speed
// w is positive and the medium presses with k1 w + k2 w^2 on it.

// Does what add_drag does.
double add_stretched_drag(const PlanarModel& model, const Medium& medium,
                          const Kinematics& kinematics, Loads& loads);

}  // namespace cambrian
