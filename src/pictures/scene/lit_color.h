#pragma once

#include "render/color.h"
#include "render/skin.h"

#include <algorithm>

namespace cambrian {

// Returns a colour as it is in the light of a frame.
inline Color lit(const Color& color, const SkinLight& light) {
    const auto part = [](float of, float fill, float key) {
        return std::min(1.0F, of * (fill + 0.55F * key));
    };
    return {part(color.r, light.fill.r, light.key.r), part(color.g, light.fill.g, light.key.g),
            part(color.b, light.fill.b, light.key.b), color.a};
}

}  // namespace cambrian
