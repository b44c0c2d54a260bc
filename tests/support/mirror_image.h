#pragma once

// The mirror image of a body. Physics does not distinguish left and right, so it must move as the
// mirror image of the original.

#include "world/body_plan.h"

namespace cambrian {

// Where world x becomes -x, there are two descriptions of the mirrored body, since a box is its own
// mirror image in two ways: with the length of every part reversed (angle a becomes -a), or with
// its width reversed (a becomes pi - a, which is rounded). Where world y becomes -y, the width is
// reversed and a becomes -a. Joints turn the other way, so their targets must be negated.
enum class Flip : std::uint8_t { kLength, kWidth, kUpsideDown };

// All joints of the plan must be rotary.
BodyPlan mirror_image(BodyPlan plan, Flip flip);

}  // namespace cambrian
