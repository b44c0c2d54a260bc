#pragma once

#include "pictures/canvas/picture_canvas.h"
#include "pictures/motion/subject.h"

namespace cambrian {

inline constexpr int kMostPoses = 48;

// Draws a sheet of the creature in motion: 1 to kMostPoses poses over its trial, all to one scale.
void draw_sheet(PictureCanvas& canvas, const Subject& subject, const Palette& palette, int poses);

}  // namespace cambrian
