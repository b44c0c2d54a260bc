#pragma once

// Organs as features of a living skin: a mouth with two teeth, the gills of a voice, the nostrils
// of a scent gland, and the folds of a part that deforms.

#include "pictures/scene/scene_builder.h"

namespace cambrian {

// Adds those that are large enough to be seen; `pixel` is the size of one, in m.
void add_organ_features(SceneFrame& frame, const CreatureLook& look, double pixel);

}  // namespace cambrian
