#pragma once

// The strokes of a pen on a body: each returns a valid genome with all numbers inside their ranges
// (sketch/README.md 2). Points are in the world of the body at rest, with the root at the origin.

#include "core/result.h"
#include "sketch/body_sketch.h"

namespace cambrian {

// Whether a new part gets a mirror image, left for right or up for down as seen.
enum class MirrorSides : unsigned char { kNone, kSideways, kUpright };

// Returns the axis of a part that mirrors it in that way.
MirrorAxis axis_of(MirrorSides sides, double part_angle);

struct NewPart {
    Vec2 from = Vec2::Zero();  // its joint goes to the nearest place of the parent's outline
    Vec2 to = Vec2::Zero();    // its far end
    MirrorSides mirror = MirrorSides::kNone;
};
struct GrownPart {
    Genome genome;
    PartName name;
};
// Fails where the body has no room for one more.
Result<GrownPart> grow_part(const BodySketch& sketch, std::size_t parent, const NewPart& drawn,
                            const SketchRules& rules);

// Moves a part's far end: it turns about its joint and gets longer or shorter. The root turns about
// its middle, which stays.
Genome drag_end(const BodySketch& sketch, std::size_t part, const Vec2& to);
// Moves a long side.
Genome drag_side(const BodySketch& sketch, std::size_t part, const Vec2& to);
// Moves a part, but not the root, along its parent's outline.
Genome slide_joint(const BodySketch& sketch, std::size_t part, const Vec2& to);

// Returns a genome of one part, from which a drawing begins.
Genome first_part();

}  // namespace cambrian
