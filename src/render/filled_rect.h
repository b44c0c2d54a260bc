#pragma once

#include "render/pixel_rect.h"

namespace cambrian {

// Fills pixels of the bound framebuffer with an opaque colour, without a shader. Scissoring remains
// enabled for them. Nothing happens if there are none.
void fill_rect(const PixelRect& pixels, const Color& color);

}  // namespace cambrian
