#pragma once

#include "creature/phenotype.h"
#include "studio/look/ui_context.h"

namespace cambrian {

// Draws a creature's body at rest as a small picture that fits an area, with Dear ImGui's shapes.
void draw_creature_tile(ImDrawList& list, const Rect& area, const Phenotype& phenotype, double hue);

}  // namespace cambrian
