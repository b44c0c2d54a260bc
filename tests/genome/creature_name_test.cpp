#include "genome/creature_name.h"

#include "genome/founders/random_genome.h"
#include "genome/small_catalog.h"
#include "support/catch.h"

#include <cstdint>
#include <set>
#include <string>
#include <string_view>

using namespace cambrian;

namespace {

Genome founder(std::uint64_t number) {
    RandomStream stream(stream_seed(number, 0, 0, Purpose::kTest));
    return random_genome(FounderSettings(), small_catalog(), stream);
}

bool is_pronounceable(std::string_view name) {
    int vowels = 0;
    for (const char letter : name)
        vowels += std::string_view("aeiou").find(letter) != std::string_view::npos ? 1 : 0;
    return vowels == 3 && name.size() >= 6 && name.size() <= 11;
}

}  // namespace

TEST_CASE("names of random creatures can be spoken, and hardly two are the same",
          "[genome][name]") {
    std::set<std::string> names;
    for (std::uint64_t i = 0; i < 10'000; ++i) {
        const std::string name = creature_name(founder(i));
        INFO(name);
        REQUIRE(is_pronounceable(name));
        names.insert(name);
    }
    CHECK(names.size() >= 9'600);  // of 168 150 drawn alike, 9 707 are expected
}

TEST_CASE("a genome has the same name for ever", "[genome][name]") {
    CHECK(coined_name(0) == "Balala");
    CHECK(coined_name(1) == "Belala");
    CHECK(coined_name(0x123456789abcdef0) == "Bamonoth");
    CHECK(coined_name(0xffffffffffffffff) == "Brimasar");
    CHECK(creature_name(founder(7)) == "Trilvorax");
}

TEST_CASE("a given name wins, and is shown on one line", "[genome][name]") {
    Genome genome = founder(7);
    genome.name = "Old\nGrendel";
    CHECK(creature_name(genome) == "Old Grendel");
    genome.name.clear();
    genome.hue = 0.9;
    CHECK(creature_name(genome) == creature_name(founder(7)));
}
