#pragma once

// Contact points of two boxes by separating axes (S. Gottschalk, M. C. Lin, D. Manocha, OBBTree,
// SIGGRAPH 1996): three axes of either box and nine across an edge of both.

#include "spatial/algebra.h"

namespace cambrian::spatial {

struct PlacedBox {
    Vec3 center = Vec3::Zero();  // m
    Turn axes;
    Vec3 half = Vec3::Zero();  // m
};

inline constexpr int kBoxPoints = 4;
inline constexpr int kBoxFeatures = 4752;

struct BoxPoint {
    int feature = 0;            // 0 to kBoxFeatures - 1, constant while the same ones touch
    Vec3 place = Vec3::Zero();  // m, on the incident box
    double gap = 0.0;           // m, along the normal
};

struct BoxManifold {
    bool first_is_incident = false;  // the points belong to the incident box
    // The normal, unit, from the reference box to the incident one, and two tangents that turn with
    // the reference box.
    Turn surface;
    int count = 0;
    BoxPoint points[kBoxPoints];  // by their features
};

// Returns the largest gap between the projections of two boxes on the 15 axes, m; negative if they
// overlap.
double gap_between(const PlacedBox& first, const PlacedBox& second);

// The axis of the largest gap is the normal. If it is that of a face, the facing face of the other
// box is clipped to it, and no more than four points remain; if it is across two edges, the point
// where they pass each other remains. There are no points if the boxes are farther apart than
// margin (m).
BoxManifold collide_boxes(const PlacedBox& first, const PlacedBox& second, double margin);

}  // namespace cambrian::spatial
