#pragma once

// Pictures as textures of OpenGL, for drawing them in the window.

#include "core/image.h"

#include <imgui.h>

#include <memory>
#include <vector>

namespace cambrian {

// Needs a current context of OpenGL, also at its end.
class Textures {
public:
    Textures() = default;
    ~Textures();
    Textures(const Textures&) = delete;
    Textures& operator=(const Textures&) = delete;

    // Returns the texture of a picture. It is made when it is asked for first, and kept.
    ImTextureID of(const std::shared_ptr<const Image>& picture);

private:
    struct Kept {
        std::shared_ptr<const Image> picture;
        unsigned texture = 0;
    };
    std::vector<Kept> kept_;
};

}  // namespace cambrian
