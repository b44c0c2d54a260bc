#pragma once

// Contact points of two boxes (planar/README.md 8): the axis of least penetration gives the
// reference face, and the incident face of the other box is clipped to it.

#include "planar/contact/contact.h"
#include "planar/model/kinematics.h"

#include <cstdint>

namespace cambrian {

// One box, or four of them.
template <class Scalar>
struct PlacedBoxes {
    Scalar x, y;            // m
    Scalar axis_x, axis_y;  // unit, along the length
    Scalar half_length, half_width;
};
using PlacedBox = PlacedBoxes<double>;

struct BoxManifold {
    bool first_is_incident = false;         // the points belong to the incident box
    double normal_x = 0.0, normal_y = 0.0;  // unit, from the reference box to the incident one
    int count = 0;                          // 0 to 2
    int corner[2] = {};                     // of the incident box: bit 0 is +x, bit 1 is +y
    double x[2] = {}, y[2] = {};            // m, world, on the incident face
    double gap[2] = {};                     // m, along the normal
};

inline PlacedBox placed_box(const PartPlaces& places, int part) {
    return {places.x[part],      places.y[part],           places.axis_x[part],
            places.axis_y[part], places.half_length[part], places.half_width[part]};
}

// Returns four boxes, from `first` on.
CAMBRIAN_INLINE PlacedBoxes<Simd4d> four_boxes(const PartPlaces& places, int first) {
    return {load_lanes(places.x + first),           load_lanes(places.y + first),
            load_lanes(places.axis_x + first),      load_lanes(places.axis_y + first),
            load_lanes(places.half_length + first), load_lanes(places.half_width + first)};
}

// The way in which two boxes lie. One of the two may be four boxes, each beside the other.
template <class Scalar>
struct BoxRelation {
    Scalar x, y;    // m, from the centre of the first to that of the second
    Scalar along;   // share of one box's length that lies along the other's, 0 to 1
    Scalar across;  // share that lies across
};

template <class First, class Second>
CAMBRIAN_INLINE auto relation_of(const PlacedBoxes<First>& a, const PlacedBoxes<Second>& b) {
    using Scalar = decltype(a.x * b.x);
    return BoxRelation<Scalar>{b.x - a.x, b.y - a.y,
                               magnitude(a.axis_x * b.axis_x + a.axis_y * b.axis_y),
                               magnitude(a.axis_x * b.axis_y - a.axis_y * b.axis_x)};
}

// Gaps between the projections of two boxes on both axes of one of them, m.
template <class Scalar>
struct AxisGaps {
    Scalar length, width;
};

// The relation is the same for either box.
template <class Own, class Other, class Scalar>
CAMBRIAN_INLINE AxisGaps<Scalar> axis_gaps(const PlacedBoxes<Own>& own,
                                           const PlacedBoxes<Other>& other,
                                           const BoxRelation<Scalar>& relation) {
    const auto& [x, y, along, across] = relation;
    return {magnitude(own.axis_x * x + own.axis_y * y) - own.half_length -
                along * other.half_length - across * other.half_width,
            magnitude(own.axis_x * y - own.axis_y * x) - own.half_width -
                across * other.half_length - along * other.half_width};
}

// Returns the face of a part whose normal is nearest to a direction in the world.
inline std::uint8_t touching_face(const PartPlaces& places, int part, double x, double y) {
    const double along = places.axis_x[part] * x + places.axis_y[part] * y;
    const double across = places.axis_x[part] * y - places.axis_y[part] * x;
    return static_cast<std::uint8_t>(face_toward(along, across));
}

// Returns no points if the boxes are farther apart than margin.
BoxManifold collide_boxes(const PlacedBox& first, const PlacedBox& second, double margin);

// How far boxes move past each other between two poses, so that none passes another one unseen
// (planar/README.md 8). Lengths of vectors are bounded from above, at most by an eighth too long.

// The boxes of a model at both ends of a motion.
struct BoxEnds {
    const PlanarModel& model;
    const PartPlaces& from;
    const PartPlaces& to;
};

// The motion of each box between the ends.
struct BoxTravels {
    PerPart turn;    // rad
    PerPart swing;   // m; most that a point within the circle around it moves beside its centre
    PerPart beside;  // m; most that such a point moves beside the centre of box 0
    double most_past = 0.0;  // m; no box moves farther past another one
};

// The smaller side of each box, m.
struct BoxSides {
    PerPart thin;
    double thinnest = 0.0;
};

void find_sides(const BoxEnds& ends, BoxSides& sides);
void find_travels(const BoxEnds& ends, const PerBody& from_angle, const PerBody& to_angle,
                  BoxTravels& travels);

// Returns the most that a box moves past something fixed, in m.
double travel_of(const BoxEnds& ends, const BoxTravels& travels, int part);

CAMBRIAN_INLINE Simd4d most_length(const Simd4d& x, const Simd4d& y) {
    const Simd4d a = magnitude(x);
    const Simd4d b = magnitude(y);
    return greater(a, b) + 0.5 * lesser(a, b);
}

// Returns the most that points of four boxes move by the change of their shapes, in m.
CAMBRIAN_INLINE Simd4d growths_of(const BoxEnds& ends, int first) {
    const auto change = [&](const double* from, const double* to) {
        return magnitude(load_lanes(to + first) - load_lanes(from + first));
    };
    return change(ends.from.half_length, ends.to.half_length) +
           change(ends.from.half_width, ends.to.half_width);
}

// Returns how far the centres of four boxes, from `second` on, move in the frame of another one.
CAMBRIAN_INLINE Simd4dVector moves_beside(const BoxEnds& ends, int box, int second) {
    const auto beside = [&](const PartPlaces& places) {
        return turned({load_lanes(places.x + second) - places.x[box],
                       load_lanes(places.y + second) - places.y[box]},
                      all_lanes(places.axis_x[box]), all_lanes(-places.axis_y[box]));
    };
    const Simd4dVector before = beside(ends.from);
    const Simd4dVector after = beside(ends.to);
    return {after.x - before.x, after.y - before.y};
}

}  // namespace cambrian
