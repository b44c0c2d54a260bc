#include "persist/creature/png_file.h"

#include "support/catch.h"

namespace cambrian {
namespace {

Image colorful(int width, int height) {
    Image image{width, height, {}};
    for (int i = 0; i < 3 * width * height; ++i)
        image.rgb.push_back(static_cast<std::uint8_t>(i * 37 % 251));
    return image;
}

TEST_CASE("a picture comes back from PNG with every pixel", "[persist][png_file]") {
    const Image image = colorful(31, 17);
    for (const auto& texts : {std::vector<PngText>{}, {{"key", "words"}}}) {
        const auto bytes = encode_png(image, texts);
        REQUIRE(bytes);
        CHECK(is_png(*bytes));
        const auto back = decode_png(*bytes);
        REQUIRE(back);
        CHECK(back->width == 31);
        CHECK(back->height == 17);
        CHECK(back->rgb == image.rgb);
    }
}

TEST_CASE("texts come back byte for byte, by keyword, in order", "[persist][png_file]") {
    const std::string odd = "Ö ∑ \n\t end";
    const auto bytes =
        encode_png(colorful(4, 4), {{"a", odd}, {"b", "other"}, {"a", ""}, {"a", odd + odd}});
    REQUIRE(bytes);
    CHECK(png_texts(*bytes, "a").value() == std::vector<std::string>{odd, "", odd + odd});
    CHECK(png_texts(*bytes, "c").value().empty());
}

TEST_CASE("a picture nobody can encode is an error", "[persist][png_file]") {
    CHECK_THAT(encode_png({0, 5, {}}).error().message, Catch::Contains("cannot be encoded"));
}

TEST_CASE("a picture cut off anywhere is an error", "[persist][png_file]") {
    constexpr std::size_t kEndChunk = 12;  // bytes of the empty chunk after the pixels
    const std::string whole = encode_png(colorful(9, 9), {{"a", "words"}}).value();
    for (std::size_t size = 0; size < whole.size(); ++size) {
        INFO(size);
        CHECK_FALSE(png_texts(std::string_view(whole).substr(0, size), "a"));
        if (size + kEndChunk < whole.size())
            CHECK_FALSE(decode_png(std::string_view(whole).substr(0, size)));
    }
    CHECK(png_texts(whole, "a"));
}

TEST_CASE("a picture with too many pixels is not decoded", "[persist][png_file]") {
    const std::string whole = encode_png(colorful(30, 20)).value();
    CHECK(decode_png(whole, {.side = 30}));
    CHECK_THAT(decode_png(whole, {.side = 29}).error().message, Catch::Contains("at most 29"));
}

TEST_CASE("a flipped bit anywhere is an error", "[persist][png_file]") {
    const std::string whole = encode_png(colorful(9, 9), {{"a", "words"}}).value();
    for (std::size_t at = 0; at < whole.size(); ++at) {
        INFO(at);
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ 0x10);
        CHECK_FALSE(png_texts(flipped, "a"));
    }
}

TEST_CASE("limits of size, of text unpacked and of chunks hold", "[persist][png_file]") {
    const std::string large = encode_png(colorful(65, 9)).value();
    CHECK_FALSE(png_texts(large, "a", {.side = 64}));
    CHECK(png_texts(large, "a", {.side = 65}));
    const std::string bomb =
        encode_png(colorful(4, 4), {{"a", std::string(1'000'000, ' ')}}).value();
    CHECK(bomb.size() < 10'000);
    CHECK_FALSE(png_texts(bomb, "a", {.text_bytes = 900'000}));
    CHECK(png_texts(bomb, "a", {.text_bytes = 1'000'000}));
    const std::string many =
        encode_png(colorful(4, 4), std::vector<PngText>(100, PngText{"a", "b"})).value();
    CHECK_FALSE(png_texts(many, "a", {.chunks = 50}));
}

}  // namespace
}  // namespace cambrian
