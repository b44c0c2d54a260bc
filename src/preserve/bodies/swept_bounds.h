#pragma once

// The place of a body and the farthest it can get within a tick.

#include "preserve/world/rectangle.h"
#include "world/body_view.h"

#include <vector>

namespace cambrian {

struct SweptBounds {
    std::vector<Rectangle> parts;
    std::vector<Bounds> boxes;  // around the parts
    double growth = 0.0;        // m; how far every point is expected to get within a tick
};

// Finds the parts and their boxes; the growth stays.
void find_parts(const BodyView& body, SweptBounds& extent);

// Moves the parts and boxes.
void move(SweptBounds& extent, const Vec3& shift);
// Returns the same elsewhere, in `memory` unless the shift (m) is zero.
const SweptBounds& seen(const SweptBounds& extent, const Vec3& shift, SweptBounds& memory);

Bounds grown(const Bounds& bounds, double growth);
// Returns the distance of two boxes along the axis on which they are farthest apart; negative if
// they overlap.
double gap_between(const Bounds& a, const Bounds& b);

// Returns the least distance of two parts' boxes.
double gap_between_boxes(const SweptBounds& a, const SweptBounds& b);
// Returns a lower bound of the least distance of two parts; negative if they overlap. It is the
// true one or nearer to it than that of boxes where it is at most `reach`.
double gap_between(const SweptBounds& a, const SweptBounds& b, double reach);
// Returns whether any corner of a part is farther than the growth from where it was.
bool has_left(const SweptBounds& before, const SweptBounds& after);

}  // namespace cambrian
