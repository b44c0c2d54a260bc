#include "render/color.h"

#include "support/catch.h"

namespace cambrian {
namespace {

// Returns the approximate relative luminance of sRGB, which suffices to compare hues.
double brightness(const Color& color) {
    return 0.2126 * static_cast<double>(color.r * color.r) +
           0.7152 * static_cast<double>(color.g * color.g) +
           0.0722 * static_cast<double>(color.b * color.b);
}

TEST_CASE("a colour without chroma is grey", "[render][color]") {
    const Color grey = color_of_hue(0.3, 0.6, 0.0);
    CHECK(grey.r == Approx(grey.g).margin(2e-3));
    CHECK(grey.g == Approx(grey.b).margin(2e-3));
}

TEST_CASE("hues of one lightness look about equally bright", "[render][color]") {
    const double grey = brightness(color_of_hue(0.0, 0.68, 0.0));
    for (int i = 0; i < 24; ++i) {
        const double one = brightness(color_of_hue(i / 24.0, 0.68, 0.1));
        CHECK(one == Approx(grey).epsilon(0.2));
    }
}

TEST_CASE("every hue stays inside the range of the screen", "[render][color]") {
    for (int i = 0; i < 100; ++i) {
        const Color color = color_of_hue(i / 100.0, 0.7, 0.4);
        for (const float channel : {color.r, color.g, color.b})
            CHECK((channel >= 0.0F && channel <= 1.0F));
    }
}

TEST_CASE("packing puts red into the lowest byte", "[render][color]") {
    CHECK(pack(color_of(0x123456)) == 0xFF563412U);
    CHECK(pack(color_of(0xFFFFFF, 0.0F)) == 0x00FFFFFFU);
}

TEST_CASE("mixing begins at the first colour and ends at the second", "[render][color]") {
    const Color a = color_of(0x204060);
    const Color b = color_of(0xE0C0A0, 0.5F);
    CHECK(mix(a, b, 0.0F) == a);
    CHECK(pack(mix(a, b, 1.0F)) == pack(b));
}

}  // namespace
}  // namespace cambrian
