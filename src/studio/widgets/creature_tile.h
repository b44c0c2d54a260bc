#pragma once

#include "creature/phenotype.h"
#include "evolution/individual/individual.h"
#include "pictures/motion/recorded_motion.h"
#include "studio/look/ui_context.h"

namespace cambrian {

// Draws a creature's body at rest as a small picture that fits an area: in its skin, or as its
// boxes if the user wants to see mechanics. `line` is that of its founder, or 0.
void draw_creature_tile(ImDrawList& list, const Rect& area, const Phenotype& phenotype, double hue,
                        std::uint64_t line);
// Draws one in motion in the same way; nothing where the motion has not begun.
void draw_moving_tile(ImDrawList& list, const Rect& area, const RecordedMotion& motion,
                      const Individual& creature, double time, bool walks);

// Returns how many tiles of a width fit side by side into a room with gaps between them, at least
// one.
int tiles_across(float room, float width, float gap);

}  // namespace cambrian
