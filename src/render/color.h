#pragma once

#include <cstdint>

namespace cambrian {

// sRGB with straight (not premultiplied) alpha, each component in [0, 1].
struct Color {
    float r = 0.0F;
    float g = 0.0F;
    float b = 0.0F;
    float a = 1.0F;

    friend bool operator==(const Color&, const Color&) = default;
};

// Returns the colour 0xRRGGBB.
constexpr Color color_of(std::uint32_t rgb, float alpha = 1.0F) {
    return {static_cast<float>((rgb >> 16U) & 0xFFU) / 255.0F,
            static_cast<float>((rgb >> 8U) & 0xFFU) / 255.0F,
            static_cast<float>(rgb & 0xFFU) / 255.0F, alpha};
}

constexpr Color with_alpha(Color color, float alpha) {
    color.a = alpha;
    return color;
}

// Interpolates linearly: share 0 gives a, 1 gives b.
Color mix(const Color& a, const Color& b, float share);

// Returns a colour whose perceived lightness does not depend on the hue: OKLCH (Ottosson 2020),
// clipped to sRGB. Lightness is in [0, 1], chroma from 0 (grey) to about 0.2, hue in turns.
Color color_of_hue(double hue, double lightness, double chroma);

// Returns the colour as four bytes, red lowest, as in vertex colours here and in Dear ImGui.
std::uint32_t pack(const Color& color);

}  // namespace cambrian
