#include "core/delta_text.h"

#include "core/random.h"
#include "support/build_speed.h"
#include "support/catch.h"

#include <algorithm>
#include <utility>

using namespace cambrian;

namespace {

std::string any_text(RandomStream& stream) {
    std::string text(stream.below(40'000), '\0');
    for (char& each : text)
        each = static_cast<char>(stream.below(64));
    return text;
}

// Returns the text with some pieces overwritten, removed and inserted.
std::string edited(std::string text, RandomStream& stream) {
    for (int i = 0; i < 5; ++i) {
        const std::size_t place = stream.below(text.size() + 1);
        const std::size_t length = std::min<std::size_t>(stream.below(20), text.size() - place);
        text.replace(place, length, std::string(stream.below(20), static_cast<char>('a' + i)));
    }
    return text;
}

}  // namespace

TEST_CASE("a text is read back from its difference, which is short", "[core][delta_text]") {
    RandomStream stream(stream_seed(1, 0, 0, Purpose::kTest));
    DeltaEncoder encoder;
    DeltaDecoder decoder;
    for (int i = 0; i < test::by_build(300, 50); ++i) {
        const std::string base = any_text(stream);
        const std::string text = edited(base, stream);
        const std::string bytes(encoder.encode(text, base));
        CHECK(bytes.size() < 400);
        const Result<std::string> back = decoder.decode(bytes, base, text.size());
        REQUIRE(back);
        REQUIRE(*back == text);
    }
}

TEST_CASE("a difference may be from nothing or to nothing", "[core][delta_text]") {
    DeltaEncoder encoder;
    DeltaDecoder decoder;
    const std::string some = "some text, as good as any other text";
    for (const auto& [text, base] : {std::pair{some, std::string()}, {std::string(), some}, {}}) {
        const std::string bytes(encoder.encode(text, base));
        const Result<std::string> back = decoder.decode(bytes, base, text.size());
        REQUIRE(back);
        CHECK(*back == text);
    }
}

TEST_CASE("a damaged difference, or one from another text, gives an error or another text",
          "[core][delta_text]") {
    RandomStream stream(stream_seed(2, 0, 0, Purpose::kTest));
    DeltaEncoder encoder;
    DeltaDecoder decoder;
    const std::string base = any_text(stream);
    const std::string text = edited(base, stream);
    const std::string bytes(encoder.encode(text, base));
    CHECK_FALSE(decoder.decode(bytes, base, text.size() + 1));
    CHECK_FALSE(decoder.decode(bytes, base, text.size() - 1));
    for (std::size_t length = 0; length < bytes.size(); ++length)
        REQUIRE_FALSE(decoder.decode(bytes.substr(0, length), base, text.size()));
    for (std::size_t place = 0; place < 8 * bytes.size(); ++place) {
        std::string damaged = bytes;
        damaged[place / 8] = static_cast<char>(damaged[place / 8] ^ (1 << (place % 8)));
        const Result<std::string> read = decoder.decode(damaged, base, text.size());
        REQUIRE((!read || read->size() == text.size()));
    }
    const Result<std::string> elsewhere = decoder.decode(bytes, base.substr(1), text.size());
    CHECK((!elsewhere || *elsewhere != text));
    CHECK(*decoder.decode(bytes, base, text.size()) == text);
}
