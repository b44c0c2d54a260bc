#pragma once

// The small signs of organs on a creature's parts.

#include "creature/phenotype.h"
#include "render/scene_frame.h"

#include <span>

namespace cambrian {

// Adds a sign for each organ, with the parts at `poses` and of the shapes of shown_shape.h; `pixel`
// is the size of one, in m.
void add_organ_marks(SceneFrame& frame, const Phenotype& phenotype, std::span<const Pose> poses,
                     std::span<const double> stretches, double pixel);

}  // namespace cambrian
