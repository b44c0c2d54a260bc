#pragma once

#include "pictures/canvas/picture_canvas.h"
#include "pictures/motion/subject.h"

namespace cambrian {

inline constexpr int kCardWidth = 960;  // pixels; default width
inline constexpr int kCardHeight = 1280;

// Draws the picture of a creature card: the creature, its name and score, and a strip of its
// motion.
void draw_card(PictureCanvas& canvas, const Subject& subject, const Palette& palette);

}  // namespace cambrian
