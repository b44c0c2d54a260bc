#pragma once

#include "pictures/canvas/picture_canvas.h"
#include "pictures/motion/subject.h"
#include "pictures/scene/moment.h"

namespace cambrian {

inline constexpr int kCardWidth = 960;  // pixels; default width
inline constexpr int kCardHeight = 1280;
inline constexpr int kMovingCardWidth = 600;  // pixels; default width of a card that moves
inline constexpr int kMovingCardHeight = 800;
inline constexpr double kMovingCardSeconds = 4.0;  // s, of one round

// Draws the picture of a creature card: the creature, its name and score, and a strip of its
// motion.
void draw_card(PictureCanvas& canvas, const Subject& subject, const Palette& palette);

// Draws a picture of a card that moves: the creature at this moment.
void draw_moving_card(PictureCanvas& canvas, const Subject& subject, const Palette& palette,
                      const Moment& moment);

}  // namespace cambrian
