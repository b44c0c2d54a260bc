#pragma once

#include <cstdint>

namespace cambrian {

// Straight (not premultiplied) sRGB, each 0 to 1.
struct Color {
    float r = 0.0F;
    float g = 0.0F;
    float b = 0.0F;
    float a = 1.0F;

    friend bool operator==(const Color&, const Color&) = default;
};

// 0xRRGGBB.
constexpr Color color_of(std::uint32_t rgb, float alpha = 1.0F) {
    return {static_cast<float>((rgb >> 16U) & 0xFFU) / 255.0F,
            static_cast<float>((rgb >> 8U) & 0xFFU) / 255.0F,
            static_cast<float>(rgb & 0xFFU) / 255.0F, alpha};
}

constexpr Color with_alpha(Color color, float alpha) {
    color.a = alpha;
    return color;
}

// share 0 gives a, 1 gives b.
Color mix(const Color& a, const Color& b, float share);

// A colour of equal perceived lightness for every hue: OKLCH (Ottosson 2020), clipped to sRGB.
// lightness 0 to 1, chroma 0 (grey) to about 0.2, hue in turns.
Color color_of_hue(double hue, double lightness, double chroma);

// Four bytes, red lowest: the layout of vertex colours here and in Dear ImGui.
std::uint32_t pack(const Color& color);

}  // namespace cambrian
