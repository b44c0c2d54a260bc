#pragma once

#include "render/color.h"

#include <array>

namespace cambrian {

// Detects whether the window's framebuffer still holds the last frame, by an invisible mark in its
// lower left pixel. Software drivers keep the framebuffer and gain most from painting less. With
// other drivers it does not look, since reading a pixel would stall them. Needs a current OpenGL
// context.
class PictureStamp {
public:
    PictureStamp();

    // Must be called before painting; returns true if the framebuffer holds the last frame.
    bool found() const;
    // Must be called after painting; `background` is the colour at the corner.
    void put(const Color& background);

private:
    bool in_software_;
    std::array<unsigned char, 3> mark_{};  // red, green and blue in the last frame
    unsigned frame_ = 0;
};

}  // namespace cambrian
