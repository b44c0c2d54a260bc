#include "render/color.h"

#include "math/elementary.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

float encode_srgb(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double encoded = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<float>(encoded);
}

std::uint32_t byte_of(float share) {
    return static_cast<std::uint32_t>(std::lround(std::clamp(share, 0.0F, 1.0F) * 255.0F));
}

}  // namespace

Color mix(const Color& a, const Color& b, float share) {
    const auto blend = [share](float from, float to) { return from + (to - from) * share; };
    return {blend(a.r, b.r), blend(a.g, b.g), blend(a.b, b.b), blend(a.a, b.a)};
}

// Converts OKLCH to OKLab, to cone responses (cubed), to linear sRGB. The matrices are Ottosson's.
Color color_of_hue(double hue, double lightness, double chroma) {
    const SineCosine turn = sine_cosine(2.0 * kPi * hue);
    const double a = chroma * turn.cosine;
    const double b = chroma * turn.sine;
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {encode_srgb(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encode_srgb(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encode_srgb(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s), 1.0F};
}

std::uint32_t pack(const Color& color) {
    return byte_of(color.r) | byte_of(color.g) << 8U | byte_of(color.b) << 16U |
           byte_of(color.a) << 24U;
}

}  // namespace cambrian
