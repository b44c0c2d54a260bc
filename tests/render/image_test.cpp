#include "render/image.h"

#include "support/catch.h"

namespace cambrian {
namespace {

std::uint32_t big_endian(const std::string& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

TEST_CASE("an image is written as a PNG of its size", "[render][image]") {
    const Image image{3, 2, std::vector<std::uint8_t>(18, 200)};
    const std::string png = encode_png(image);
    REQUIRE(png.size() > 33);
    CHECK(png.substr(1, 3) == "PNG");
    CHECK(big_endian(png, 16) == 3);
    CHECK(big_endian(png, 20) == 2);
    CHECK(png.substr(png.size() - 8, 4) == "IEND");
}

}  // namespace
}  // namespace cambrian
