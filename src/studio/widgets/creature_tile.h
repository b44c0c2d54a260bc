#pragma once

#include "creature/phenotype.h"
#include "studio/look/ui_context.h"

namespace cambrian {

// A creature's body at rest, drawn small with Dear ImGui's own shapes, fitted into an area.
void draw_creature_tile(ImDrawList& list, const Rect& area, const Phenotype& phenotype, double hue);

}  // namespace cambrian
