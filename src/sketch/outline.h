#pragma once

// The outline of a part, along which others are attached, and the inverse of an attachment
// (sketch/README.md 1).

#include "sketch/body_sketch.h"

namespace cambrian {

// A place on a part's outline, in the part's frame at rest.
struct OutlinePlace {
    double position = 0.0;      // as in EdgeGene, before mirroring
    Vec2 point = Vec2::Zero();  // m
    double distance = 0.0;      // m, from where it was looked for
};
// Returns the nearest place at which children may grow. The point is in the part's frame.
OutlinePlace nearest_on_outline(const BodyPart& part, const Vec2& inside);

// Returns the position of an edge whose child has its joint as near as possible to a point of the
// world. `image_by` is set if it is the mirror image that is placed there.
double aimed_position(const BodySketch& sketch, std::size_t parent,
                      std::optional<MirrorAxis> image_by, const Vec2& joint);
// Returns the angle of an edge whose child points as nearly as possible along a direction of the
// world, in rad.
double aimed_angle(const BodySketch& sketch, std::size_t parent, std::optional<MirrorAxis> image_by,
                   double position, double direction);
// Returns the direction of a child at rest in the world, in rad.
double direction_of(const BodySketch& sketch, std::size_t parent,
                    std::optional<MirrorAxis> image_by, const EdgeGene& edge);

}  // namespace cambrian
