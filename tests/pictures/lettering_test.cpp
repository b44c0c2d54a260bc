#include "pictures/canvas/lettering.h"

#include "support/catch.h"

#include <algorithm>

namespace cambrian {
namespace {

Image black(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height))};
}

const Lettering& lettering() {
    static const auto loaded = Lettering::load();
    REQUIRE(loaded);
    return **loaded;
}

bool any_light(const Image& image) {
    return std::any_of(image.rgb.begin(), image.rgb.end(), [](std::uint8_t v) { return v > 128; });
}

constexpr Color kWhite = color_of(0xFFFFFF);

TEST_CASE("words appear where they are put, and longer ones are wider", "[pictures][lettering]") {
    Image image = black(200, 40);
    lettering().draw(image, 10, 30, "Walker", Typeface::kRegular, 24, kWhite);
    CHECK(any_light(image));
    for (int y = 0; y < 40; ++y)
        CHECK(image.pixel(5, y)[0] == 0);
    CHECK(lettering().width("Walker", Typeface::kRegular, 24) >
          lettering().width("Walk", Typeface::kRegular, 24));
    CHECK(lettering().width("", Typeface::kRegular, 24) == 0.0);
}

TEST_CASE("letters beyond the picture are left out", "[pictures][lettering]") {
    Image image = black(20, 10);
    lettering().draw(image, -15, 4, "Wide words, much too large", Typeface::kStrong, 60, kWhite);
    lettering().draw(image, 1000, 1000, "far away", Typeface::kStrong, 60, kWhite);
    CHECK(image.rgb.size() == 600);
}

TEST_CASE("words too wide are cut off between letters", "[pictures][lettering]") {
    const std::string words = "Größenwahnsinniger Läufer";
    const std::string cut = lettering().fit(words, Typeface::kRegular, 20, 60);
    CHECK(lettering().width(cut, Typeface::kRegular, 20) <= 60);
    CHECK_THAT(cut, Catch::StartsWith("Gr") && Catch::EndsWith("…"));
    CHECK(lettering().fit(words, Typeface::kRegular, 20, 1e4) == words);
    CHECK(lettering().fit(words, Typeface::kRegular, 20, 1.0) == "…");
}

TEST_CASE("text that is no UTF-8 is drawn all the same", "[pictures][lettering]") {
    for (const char* broken : {"\xff\xfe", "a\xc3", "\xe2\x82", "\xf0\x9f\x90\x9b", "\x80"}) {
        Image image = black(80, 40);
        lettering().draw(image, 2, 30, broken, Typeface::kRegular, 24, kWhite);
        CHECK(lettering().width(broken, Typeface::kRegular, 24) > 0.0);
    }
}

}  // namespace
}  // namespace cambrian
