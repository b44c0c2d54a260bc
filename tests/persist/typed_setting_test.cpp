#include "persist/settings/typed_setting.h"

#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

std::string message_of_typed(const std::string& assignment) {
    const auto settings = with_typed({}, {assignment}, kinds());
    return settings ? "no error" : settings.error().message;
}

}  // namespace

TEST_CASE("settings are typed with or without their table and quotes", "[persist]") {
    const auto settings =
        with_typed({},
                   {"environment.gravity=1.62", "size=40", "method=rank",
                    "goal.behavior=\"swimming\"", "stop-hopeless=true", "terrain-points=0 0; 4 1"},
                   kinds());
    REQUIRE(settings);
    CHECK(settings->world.environment.gravity == 1.62);
    CHECK(settings->population.size == 40);
    CHECK(settings->selection.method == "rank");
    CHECK(settings->goal == "swimming");
    CHECK(settings->world.environment.terrain.points == "0 0; 4 1");
    CHECK(settings->terminate_early);
}

TEST_CASE("a goal that is typed brings its world, as one in the file does", "[persist]") {
    const auto typed = merge_typed({"[population]\nsize = 40\n", "plain.toml"},
                                   {"goal.behavior=swimming"}, kinds());
    REQUIRE(typed);
    ExperimentSettings expected = default_settings("swimming", kinds());
    expected.population.size = 40;
    CHECK(*typed == expected);
}

TEST_CASE("a typed setting leaves the opponents of a contest", "[persist]") {
    ExperimentSettings settings = default_settings("competition", kinds());
    settings.world.opponents.genomes = {fish(kinds().creature.catalog)};
    const auto longer = with_typed(settings, {"trial.duration=12"}, kinds());
    REQUIRE(longer);
    CHECK(longer->world.opponents == settings.world.opponents);
    const auto walking = with_typed(settings, {"goal.behavior=walking"}, kinds());
    REQUIRE(walking);
    CHECK(walking->world.opponents.genomes.empty());
}

TEST_CASE("a later text replaces what an earlier one says, and nothing else", "[persist]") {
    const auto settings =
        merge_settings({{"[goal]\nbehavior = \"swimming\"\n[population]\nsize = 40\n", "world"},
                        {"[population]\nsize = 50\nimmigrants = 3\n", "arm"}},
                       kinds());
    REQUIRE(settings);
    ExperimentSettings expected = default_settings("swimming", kinds());
    expected.population.size = 50;
    expected.population.immigrants = 3;
    CHECK(*settings == expected);
    const auto bad = merge_settings({{"", "world"}, {"[population]\nsiz = 5\n", "arm"}}, kinds());
    REQUIRE_FALSE(bad);
    CHECK(bad.error().message.starts_with("arm: line 2, [population] siz: unknown key"));
}

TEST_CASE("what is typed wrongly is told", "[persist]") {
    CHECK(message_of_typed("gravty=3") ==
          "\"gravty=3\": unknown setting; did you mean \"gravity\"?");
    CHECK(message_of_typed("gravity") ==
          "\"gravity\": expected a setting and its value, as selection.method=rank");
    CHECK(message_of_typed("selection.method=luck").find("luck") != std::string::npos);
    CHECK(message_of_typed("population.size=-1").find("-1 is outside") != std::string::npos);
}
