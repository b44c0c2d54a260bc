// For any bytes, the loader gives a valid genome or a message.

#include "core/random.h"
#include "evolution/fields/setting_field.h"
#include "genome/founders/random_genome.h"
#include "persist/sample_creature.h"
#include "persist/settings/settings_file.h"
#include "support/build_speed.h"
#include "support/catch.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

// Changes, inserts, removes or doubles one to four bytes, or cuts off the end.
std::string damaged(std::string text, RandomStream& stream) {
    if (stream.chance(0.2)) return text.substr(0, stream.below(text.size()));
    const int changes = stream.between(1, 4);
    for (int i = 0; i < changes && !text.empty(); ++i) {
        const std::size_t place = stream.below(text.size());
        const char byte = static_cast<char>(stream.below(256));
        switch (stream.below(4)) {
            case 0:
                text[place] = byte;
                break;
            case 1:
                text.insert(place, 1, byte);
                break;
            case 2:
                text.erase(place, 1 + stream.below(8));
                break;
            default:
                text.insert(place, text.substr(stream.below(text.size()), stream.below(200)));
        }
    }
    return text;
}

// Replaces one character by a digit, letter or mark, so that most results are still JSON.
std::string altered(std::string text, RandomStream& stream) {
    constexpr std::string_view kLikely = "0123456789-.e\"[]{},:abcnNtf ";
    text[stream.below(text.size())] = kLikely[stream.below(kLikely.size())];
    return text;
}

bool valid_or_explained(const std::string& text) {
    const auto loaded = parse_creature(text, "damaged", kinds());
    if (!loaded) return loaded.error().message.starts_with("damaged: E");
    return validate(loaded->genome(), kinds().creature.catalog).empty();
}

}  // namespace

TEST_CASE("no damage to a creature file does more than fail to load", "[persist][damage]") {
    RandomStream stream(71);
    const std::string sample = sample_text();
    for (int i = 0; i < 4000; ++i)
        REQUIRE(valid_or_explained(damaged(sample, stream)));
    for (int i = 0; i < 4000; ++i)
        REQUIRE(valid_or_explained(altered(sample, stream)));
}

TEST_CASE("no damage to a random creature's file does more than fail to load",
          "[persist][damage]") {
    RandomStream stream(72);
    for (int i = 0; i < 200; ++i) {
        const CreatureDocument document{unjudged(std::make_shared<const Genome>(
            random_genome(FounderSettings{}, kinds().creature.catalog, stream)))};
        const std::string text = write_creature(document, kinds());
        for (int j = 0; j < 10; ++j)
            REQUIRE(valid_or_explained(altered(damaged(text, stream) + " ", stream)));
    }
}

TEST_CASE("a creature file cut off anywhere fails to load", "[persist][damage]") {
    const std::string text = sample_text();
    for (std::size_t size = 0; size + 2 < text.size(); size += 7)
        REQUIRE_FALSE(parse_creature(text.substr(0, size), "cut", kinds()));
}

TEST_CASE("no damage to a settings file does more than fail to load", "[persist][damage]") {
    RandomStream stream(73);
    const std::string sample = write_settings(ExperimentSettings{}, kinds());
    for (int i = 0; i < test::by_build(2000, 600); ++i) {
        const std::string text = i % 2 == 0 ? damaged(sample, stream) : altered(sample, stream);
        const auto loaded = parse_settings(text, "damaged", kinds());
        if (!loaded) {
            REQUIRE(loaded.error().message.starts_with("damaged: "));
            continue;
        }
        REQUIRE(check_settings(*loaded, kinds()));
    }
}
