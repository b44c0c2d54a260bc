#pragma once

#include "world/body_plan.h"

namespace cambrian {

// Returns whether any two parts that are not connected by a joint overlap at rest
// (creature/README.md 4, setting `strict-overlap`). Touching parts do not overlap.
bool overlaps_itself(const BodyPlan& plan);

}  // namespace cambrian
