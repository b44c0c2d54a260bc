#include "pictures/canvas/text_rasterizer.h"

#include "support/catch.h"

#include <algorithm>
#include <set>
#include <vector>

namespace cambrian {
namespace {

Image black(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(3 * width * height))};
}

const TextRasterizer& text_rasterizer() {
    static const auto loaded = TextRasterizer::load();
    REQUIRE(loaded);
    return **loaded;
}

bool any_light(const Image& image) {
    return std::any_of(image.rgb.begin(), image.rgb.end(), [](std::uint8_t v) { return v > 128; });
}

constexpr Color kWhite = color_of(0xFFFFFF);

TEST_CASE("text appears at its position, and longer text is wider", "[pictures][text_rasterizer]") {
    Image image = black(200, 40);
    text_rasterizer().draw(image, 10, 30, "Walker", Typeface::kRegular, 24, kWhite);
    CHECK(any_light(image));
    for (int y = 0; y < 40; ++y)
        CHECK(image.pixel(5, y)[0] == 0);
    CHECK(text_rasterizer().width("Walker", Typeface::kRegular, 24) >
          text_rasterizer().width("Walk", Typeface::kRegular, 24));
    CHECK(text_rasterizer().width("", Typeface::kRegular, 24) == 0.0);
}

TEST_CASE("letters outside the picture are not drawn", "[pictures][text_rasterizer]") {
    Image image = black(20, 10);
    text_rasterizer().draw(image, -15, 4, "Wide words, much too large", Typeface::kStrong, 60,
                           kWhite);
    text_rasterizer().draw(image, 1000, 1000, "far away", Typeface::kStrong, 60, kWhite);
    CHECK(image.rgb.size() == 600);
}

TEST_CASE("text that is too wide is shortened between letters", "[pictures][text_rasterizer]") {
    const std::string words = "Größenwahnsinniger Läufer";
    const std::string cut = text_rasterizer().fit(words, Typeface::kRegular, 20, 60);
    CHECK(text_rasterizer().width(cut, Typeface::kRegular, 20) <= 60);
    CHECK_THAT(cut, Catch::StartsWith("Gr") && Catch::EndsWith("…"));
    CHECK(text_rasterizer().fit(words, Typeface::kRegular, 20, 1e4) == words);
    CHECK(text_rasterizer().fit(words, Typeface::kRegular, 20, 1.0) == "…");
}

TEST_CASE("text that is not UTF-8 is still drawn", "[pictures][text_rasterizer]") {
    for (const char* broken : {"\xff\xfe", "a\xc3", "\xe2\x82", "\xf0\x9f\x90\x9b", "\x80"}) {
        Image image = black(80, 40);
        text_rasterizer().draw(image, 2, 30, broken, Typeface::kRegular, 24, kWhite);
        CHECK(image.rgb != black(80, 40).rgb);
        CHECK(text_rasterizer().width(broken, Typeface::kRegular, 24) > 0.0);
    }
}

TEST_CASE("letters that the typeface lacks come from the system's others",
          "[pictures][text_rasterizer]") {
    // The three letters of Georgian are of different widths; the box for missing ones has one
    // width.
    std::vector<double> widths;
    for (const char* letter : {"ა", "ჩ", "ო"})
        widths.push_back(text_rasterizer().width(letter, Typeface::kRegular, 24));
    CHECK(std::set<double>(widths.begin(), widths.end()).size() > 1);
    const auto files = files_with({0x10D0, 0x0416, 0x10FFFF}, Typeface::kStrong);
    std::size_t letters = 0;
    for (const LettersOfFile& each : files) {
        CHECK(std::filesystem::exists(each.file.path));
        CHECK(TextRasterizer::can_read(each.file));
        letters += each.letters.size();
    }
    CHECK(letters == 2);
}

}  // namespace
}  // namespace cambrian
