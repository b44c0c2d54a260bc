#pragma once

// How far boxes move past each other between two poses, so that none passes another one unseen
// (dynamics/README.md 8). Lengths of vectors are bounded from above, at most by an eighth too long.

#include "dynamics/contact/box_contacts.h"

namespace cambrian {

// The boxes of a model at both ends of a motion.
struct BoxEnds {
    const PlanarModel& model;
    const PartPlaces& from;
    const PartPlaces& to;
};

// What each box does between the ends.
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
