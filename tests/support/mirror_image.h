#pragma once

// The mirror image of a body. Physics does not distinguish left and right, so it must move as the
// mirror image of the original.

#include "world/body_plan.h"

namespace cambrian {

// World x becomes -x. A box is its own mirror image in two ways, so there are two descriptions of
// the mirrored body: with the length of every part reversed (angle a becomes -a), or with its width
// reversed (a becomes pi - a). Joints turn the other way, so their targets must be negated.
enum class Flip : std::uint8_t { kLength, kWidth };

// All joints of the plan must be rotary.
BodyPlan mirror_image(BodyPlan plan, Flip flip);

}  // namespace cambrian
