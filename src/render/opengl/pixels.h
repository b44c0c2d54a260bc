#pragma once

#include "core/image.h"
#include "render/opengl/framebuffer.h"

namespace cambrian {

// Reads the lower left width x height pixels of the bound framebuffer. Waits for the graphics card.
Image read_pixels(int width, int height);

// A rectangle of a framebuffer in pixels; left, low is its lower left corner.
struct ReadArea {
    int left = 0;
    int low = 0;
    int width = 1;
    int height = 1;

    friend bool operator==(const ReadArea&, const ReadArea&) = default;
};
// Reads a part of the bound framebuffer.
Image read_pixels(const ReadArea& area);
// Reads a part of the window's framebuffer, smoothly scaled to the size of another one, which loses
// its content. The window's is bound afterwards.
Image read_scaled(const ReadArea& area, const Framebuffer& scaled);

}  // namespace cambrian
