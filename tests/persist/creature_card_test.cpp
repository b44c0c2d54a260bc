#include "persist/creature/creature_card.h"

#include "core/files/file_io.h"
#include "persist/creature/png_file.h"
#include "persist/sample_creature.h"
#include "support/catch.h"
#include "support/temporary_directory.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

Image picture() {
    return {8, 8, std::vector<std::uint8_t>(192, 90)};
}

std::string card_of(const std::string& document) {
    return encode_card(picture(), document).value();
}

std::string refusal_of(const std::string& bytes) {
    const auto document = card_document(bytes, "some.card.png");
    REQUIRE_FALSE(document);
    CHECK_THAT(document.error().message,
               Catch::StartsWith("some.card.png: ") && Catch::Contains("expected a creature card"));
    return document.error().message;
}

}  // namespace

TEST_CASE("a card carries the creature file byte for byte", "[persist][creature_card]") {
    const std::string text = sample_text();
    CHECK(card_document(card_of(text), "a.card.png").value() == text);
}

TEST_CASE("a card opens as the creature file it carries does", "[persist][creature_card]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "posted.png";
    REQUIRE(save_card(path, picture(), sample_text()));
    const auto loaded = load_creature(path, kinds());
    REQUIRE(loaded);
    CHECK(write_creature(*loaded, kinds()) ==
          write_creature(parse_creature(sample_text(), "", kinds()).value(), kinds()));
    CHECK(read_creature_text(path).value() == sample_text());
}

TEST_CASE("what makes a file a card is its bytes, not its name", "[persist][creature_card]") {
    const TemporaryDirectory folder;
    REQUIRE(save_card(folder.path() / "a.creature.json", picture(), sample_text()));
    CHECK(load_creature(folder.path() / "a.creature.json", kinds()));
    REQUIRE(write_file(folder.path() / "b.card.png", sample_text()));
    CHECK(load_creature(folder.path() / "b.card.png", kinds()));
}

TEST_CASE("a fault of the creature inside is told as of a creature file",
          "[persist][creature_card]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "a.card.png";
    REQUIRE(save_card(path, picture(), "{\"format\": \"geojson\"}"));
    CHECK_THAT(load_creature(path, kinds()).error().message,
               Catch::StartsWith(path.string() + ": E03 /format"));
}

TEST_CASE("a picture without a creature, or with two, is refused", "[persist][creature_card]") {
    CHECK_THAT(refusal_of(encode_png(picture()).value()),
               Catch::Contains("a picture without a creature inside"));
    const PngText creature{std::string(kCardKeyword), sample_text()};
    CHECK_THAT(refusal_of(encode_png(picture(), {creature, creature}).value()),
               Catch::Contains("2 creatures in one picture"));
}

TEST_CASE("a card cut off or damaged is refused", "[persist][creature_card]") {
    const std::string card = card_of(sample_text());
    CHECK_THAT(refusal_of(card.substr(0, card.size() / 2)), Catch::Contains("cut off"));
    CHECK_THAT(refusal_of(card.substr(0, 8)), Catch::Contains("cut off"));
    std::string damaged = card;
    damaged[damaged.find("iTXt") + 60] ^= 1;
    CHECK_THAT(refusal_of(damaged), Catch::Contains("CRC"));
}

TEST_CASE("a small card that unpacks to a huge text is refused", "[persist][creature_card]") {
    const std::string bomb = card_of(std::string(200'000'000, ' '));
    CHECK(bomb.size() < 1'000'000);
    CHECK_THAT(refusal_of(bomb), Catch::Contains("iTXt"));
}

TEST_CASE("a card of many texts, each as large as may be, is refused", "[persist][creature_card]") {
    const std::vector<PngText> texts(20, {"Comment", std::string(3'900'000, ' ')});
    CHECK_THAT(refusal_of(encode_png(picture(), texts).value()), Catch::Contains("chunk cache"));
}

TEST_CASE("a card of a picture far too large is refused", "[persist][creature_card]") {
    const Image wide{5000, 1, std::vector<std::uint8_t>(15'000)};
    CHECK_THAT(refusal_of(encode_card(wide, sample_text()).value()), Catch::Contains("IHDR"));
    CHECK_THAT(refusal_of(card_of("x") + std::string(kMaxCardBytes, 'x')),
               Catch::Contains("over 16 MB"));
}
