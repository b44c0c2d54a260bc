#pragma once

#include "world/body_plan.h"

namespace cambrian {

// Whether any two parts that no joint ties together overlap at rest (creature/README.md 4, option
// strictOverlap). Touching is not overlapping.
bool overlaps_itself(const BodyPlan& plan);

}  // namespace cambrian
