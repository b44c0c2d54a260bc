#pragma once

#include "pictures/canvas/easel.h"
#include "pictures/motion/subject.h"

namespace cambrian {

inline constexpr int kCardWidth = 960;  // pixels, unless asked otherwise
inline constexpr int kCardHeight = 1280;

// The picture of a creature card: the creature large, its name and score, a strip of its motion.
void draw_card(Easel& easel, const Subject& subject, const Palette& palette);

}  // namespace cambrian
