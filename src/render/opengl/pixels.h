#pragma once

#include "core/image.h"

namespace cambrian {

// Reads the lower left width x height pixels of the bound framebuffer. Waits for the graphics card.
Image read_pixels(int width, int height);

}  // namespace cambrian
