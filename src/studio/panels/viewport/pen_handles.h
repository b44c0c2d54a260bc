#pragma once

// What a pen can take hold of on a drawn body: handles, the outline from which parts grow, and the
// parts themselves.

#include "sketch/body_sketch.h"

#include <optional>
#include <vector>

namespace cambrian {

enum class PenGrip : unsigned char {
    kPaper,  // moves the view
    kGrow,   // draws a new part
    kEnd,    // turns and stretches a part
    kBack,   // the same, at the other end of the root
    kSide,   // makes it wider
    kJoint   // slides it along its parent's outline
};

struct PenAim {
    PenGrip grip = PenGrip::kPaper;
    std::size_t part = 0;
    Vec2 place = Vec2::Zero();  // of the handle, in the world
    Vec2 from = Vec2::Zero();   // where a new part begins, or where the side is
};

// Returns the handles of a part. `unit` is the length of 1/96 inch of the screen, in m.
std::vector<PenAim> pen_handles(const BodySketch& sketch, std::size_t part, double unit);

// Returns the part at a point, the last one to grow of several.
std::optional<std::size_t> part_under(const BodySketch& sketch, const Vec2& point);
// Whether a point is so near to a part that its handles stay.
bool is_near_part(const BodySketch& sketch, std::size_t part, const Vec2& point, double unit);

// Returns what a press at a point takes hold of. `lit` is the part whose handles are shown.
PenAim pen_aim(const BodySketch& sketch, std::optional<std::size_t> lit, const Vec2& point,
               double unit);

}  // namespace cambrian
