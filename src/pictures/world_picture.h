#pragma once

#include "pictures/canvas/picture_canvas.h"
#include "preserve/engine/preserve_picture.h"

#include <string>

namespace cambrian {

// Draws all of a preserve within its walls, with its name, the time and how many live there.
void draw_world_frame(PictureCanvas& canvas, const Palette& palette, const PreservePicture& picture,
                      const std::string& name);

}  // namespace cambrian
