#include "persist/settings/settings_file.h"
#include "worlds.h"

#include <fmt/core.h>

#include <string>

namespace cambrian {
namespace {

using namespace test;

std::string message_of(const std::string& text, SettingsUse use = SettingsUse::kPreserve) {
    const auto settings = parse_settings(text, "pond.toml", kinds(), use);
    return settings ? "" : settings.error().message;
}

std::string founding_message(const ExperimentSettings& settings, GenomePtr founder) {
    const auto preserve = Preserve::begin(std::make_shared<const ExperimentSettings>(settings),
                                          kinds(), {std::move(founder)});
    return preserve ? "" : preserve.error().message;
}

TEST_CASE("bad settings of a preserve give one clear message each", "[preserve]") {
    CHECK(message_of("") == "");
    CHECK(message_of("[preserve]\nbodies = \"solid\"\n") == "");
    CHECK(message_of("[preserve]\nedges = \"wrap\"\n") == "");
    CHECK(message_of("[preserve]\nedges = \"torus\"\n") ==
          "pond.toml: line 2, [preserve] edges: unknown \"torus\"; known are walls, wrap");
    CHECK(message_of("[preserve]\nedges = true\n").find("line 2, [preserve] edges: expected ") !=
          std::string::npos);
    CHECK(message_of("[preserve]\nwidth = 4\n") ==
          "pond.toml: line 2, [preserve] width: 4 is outside [5, 1000] m");
    CHECK(message_of("[preserve]\nheigt = 9\n") ==
          "pond.toml: line 2, [preserve] heigt: unknown key; did you mean \"height\"?");
    CHECK(message_of("[environment]\nground = true\n") == "");
    CHECK(message_of("[environment]\nlight = true\nlight-motion = \"jumping\"\n") ==
          "pond.toml: [environment] light-motion: a preserve's light does not move; expected "
          "\"still\", found \"jumping\"");
    CHECK(message_of("[preserve]\nwalls = \"-1 0  2.5 3; 0 0 0 1;\"\n") == "");
    CHECK(message_of("[preserve]\nwalls = 3\n") ==
          "pond.toml: line 2, [preserve] walls: expected a text, found a whole number");
    CHECK(message_of("[preserve]\nwalls = \"0 0 1 1; 0 0 1\"\n") ==
          "pond.toml: line 2, [preserve] walls: wall 2 is not 4 numbers; expected \"x y x y; "
          "...\", the ends of each in m");
    CHECK(message_of("[preserve]\nwalls = \"0 0 nan 1\"\n").find("wall 1 is not 4 numbers") !=
          std::string::npos);
    CHECK(message_of("[preserve]\nwalls = \"0 0 20 1; 0 0 0 0.1\"\n") ==
          "pond.toml: [preserve] walls: wall 2: it is 0.1 m long; expected at least 0.2 m");
    CHECK(
        message_of("[preserve]\nwalls = \"0 0 20.1 1\"\n") ==
        "pond.toml: [preserve] walls: wall 1: an end is outside the world, which has 40 m x 25 m");
    CHECK(message_of("[preserve]\nedges = \"wrap\"\nwalls = \"19 0 25 1\"\n") == "");
    CHECK(
        message_of("[preserve]\nedges = \"wrap\"\nwalls = \"21 0 19 0\"\n") ==
        "pond.toml: [preserve] walls: wall 1: an end is outside the world, which has 40 m x 25 m");
    CHECK(
        message_of("[preserve]\nedges = \"wrap\"\nwalls = \"0 0 40.1 1\"\n") ==
        "pond.toml: [preserve] walls: wall 1: an end is outside the world, which has 40 m x 25 m");
    CHECK(message_of("[preserve]\npatches = \"-1 0  2.5\"\n") == "");
    CHECK(message_of("[preserve]\npatches = \"-1 0\"\n").find("patch 1 is not 3 numbers") !=
          std::string::npos);
    CHECK(message_of("[preserve]\npatches = \"-1 0 1; 0 13 1\"\n") ==
          "pond.toml: [preserve] patches: patch 2: its middle is outside the world, which has 40 m "
          "x 25 m");
    CHECK(message_of("[preserve]\npatches = \"-1 0 0\"\n") ==
          "pond.toml: [preserve] patches: patch 1: its spread is 0 m; expected 0.1 m to 500 m");
    std::string many;
    for (int i = 0; i < 65; ++i)
        many += "0 0 1 1;";
    CHECK(message_of("[preserve]\nwalls = \"" + many + "\"\n") ==
          "pond.toml: line 2, [preserve] walls: more than 64 walls");
    CHECK(message_of("[selection]\nmethod = \"rank\"\n") ==
          "pond.toml: line 1, [selection]: unknown table");
    CHECK(message_of("[preserve]\nwidth = 9\n", SettingsUse::kExperiment) ==
          "pond.toml: line 1, [preserve]: these are the settings of a preserve; `cambrian "
          "preserve` takes them");
}

TEST_CASE("founders that cannot live there give one clear message each", "[preserve]") {
    ExperimentSettings settings = small_world();
    CHECK(
        founding_message(settings, rigid_tower(kind_catalog())) ==
        "founder 1 cannot move; expected creatures with a joint that follows more than constants");
    settings.preserve.energy_density = 0.1;
    CHECK(
        founding_message(settings, eater(0.0)) ==
        "[preserve] founders: the energy is spent after 0 of 10; expected fewer founders, or more "
        "than 0.1 J/m^2 of energy-density");
    settings.preserve.energy_density = 100.0;
    settings.preserve.plant_energy = 12'001.0;
    CHECK(founding_message(settings, eater(0.0)) ==
          "[preserve] plant-energy: one plant has 12001 J, but the world has 12000 J; "
          "expected less, or a higher energy-density");
    settings = small_world();
    settings.preserve.bodies = "solid";
    settings.preserve.width = 5.0;
    settings.preserve.height = 5.0;
    settings.preserve.energy_density = 1000.0;
    for (const char* x : {"-2.4", "-1.8", "-1.2", "-0.6", "0", "0.6", "1.2", "1.8", "2.4"})
        settings.preserve.walls += fmt::format("{0} -2.5 {0} 2.5;", x);
    CHECK_THAT(founding_message(settings, eater(0.0)),
               Catch::StartsWith("no place is left for founder ") &&
                   Catch::EndsWith("; expected fewer founders, fewer walls or a larger world"));
    settings = small_world();
    settings.preserve.width = 5.0;
    settings.preserve.height = 5.0;
    CHECK_THAT(founding_message(settings, eel(6, 1.6, 0.0, 0.5)),
               Catch::StartsWith("founder 1 is too large for the world: it needs "));
}

TEST_CASE("the settings of a preserve read back as they were written", "[preserve]") {
    ExperimentSettings settings = small_world();
    settings.preserve.bite_power = 12.5;
    settings.seed = 77;
    const std::string text = write_settings(settings, kinds(), SettingsUse::kPreserve);
    const auto read = parse_settings(text, "pond.toml", kinds(), SettingsUse::kPreserve);
    REQUIRE(read);
    CHECK(read->preserve == settings.preserve);
    CHECK(read->world == settings.world);
    CHECK(write_settings(*read, kinds(), SettingsUse::kPreserve) == text);
}

}  // namespace
}  // namespace cambrian
