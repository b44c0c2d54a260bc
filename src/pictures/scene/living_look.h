#pragma once

// Draws creatures as living beings: one skin over all parts, with eyes.

#include "pictures/scene/scene_builder.h"

namespace cambrian {

// Draws a creature in the mode of its look. In LookMode::kMechanics that is add_creature().
void add_being(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const CreatureLook& look);

// Draws a creature pale, behind the displayed one: in its skin, or as in add_ghost().
void add_pale_being(SceneFrame& frame, const Camera& camera, const CreatureLook& look);

// Adds the skin alone.
void add_skin_of(SceneFrame& frame, const Camera& camera, const CreatureLook& look, float alpha);

}  // namespace cambrian
