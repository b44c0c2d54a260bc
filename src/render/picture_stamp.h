#pragma once

#include "render/color.h"

#include <array>

namespace cambrian {

// Tells whether the window's framebuffer still holds the picture of the frame before, by a mark in
// its lower left pixel that no eye sees. Drivers that paint in software keep it and gain most from
// painting less; of others it is not asked, for that would make them wait. Needs a current OpenGL
// context.
class PictureStamp {
public:
    PictureStamp();

    // Before painting: true if all is as the last frame left it.
    bool found() const;
    // After painting, where the corner is of this colour.
    void put(const Color& background);

private:
    bool in_software_;
    std::array<unsigned char, 3> mark_{};  // red, green and blue of the last frame
    unsigned frame_ = 0;
};

}  // namespace cambrian
