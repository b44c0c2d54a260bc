#pragma once

#include "core/image.h"

namespace cambrian {

// The pixels of the bound framebuffer's lower left width x height corner. Waits for the graphics
// card.
Image read_pixels(int width, int height);

}  // namespace cambrian
