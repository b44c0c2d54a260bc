#pragma once

// Contact points of two boxes (dynamics/README.md 8): the axis of least penetration gives the
// reference face, and the incident face of the other box is clipped to it.

#include "dynamics/contact/contact.h"
#include "dynamics/model/part_places.h"

#include <cmath>
#include <cstdint>

namespace cambrian {

struct PlacedBox {
    double x, y;            // m
    double axis_x, axis_y;  // unit, along the length
    double half_length, half_width;
};

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

// Gaps between the projections of two boxes on both axes of one of them.
struct AxisGaps {
    double length, width;  // m
};

inline AxisGaps axis_gaps(const PlacedBox& own, const PlacedBox& other) {
    const double along = std::fabs(own.axis_x * other.axis_x + own.axis_y * other.axis_y);
    const double across = std::fabs(own.axis_x * other.axis_y - own.axis_y * other.axis_x);
    const double x = other.x - own.x;
    const double y = other.y - own.y;
    return {std::fabs(own.axis_x * x + own.axis_y * y) - own.half_length -
                along * other.half_length - across * other.half_width,
            std::fabs(own.axis_x * y - own.axis_y * x) - own.half_width -
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

}  // namespace cambrian
