#include "persist/settings/settings_file.h"

#include "core/random.h"
#include "evolution/fields/setting_field.h"
#include "persist/settings_message.h"
#include "support/build_speed.h"
#include "support/catch.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

#include <type_traits>
#include <variant>

using namespace cambrian;
using namespace cambrian::test;

namespace {

// Sets a random value of the field's type within its range.
void randomize(const SettingField& field, ExperimentSettings& settings, RandomStream& stream) {
    std::visit(
        [&](auto* at) {
            using T = std::remove_cvref_t<decltype(*at)>;
            if constexpr (std::is_same_v<T, std::string>) {
                if (!field.choices.empty()) *at = stream.pick(field.choices);
            } else if constexpr (std::is_same_v<T, bool>) {
                *at = stream.chance(0.5);
            } else {
                *at = static_cast<T>(stream.uniform(field.low, field.high));
            }
        },
        field.at(settings));
}

// Sets random shares with the sum 1.
void share_out(std::map<std::string, double>& shares) {
    double sum = 0.0;
    for (const auto& [way, share] : shares)
        sum += share;
    for (auto& [way, share] : shares)
        share /= sum;
}

}  // namespace

TEST_CASE("settings are those of a preserve if they have its table", "[persist][settings]") {
    CHECK(use_of_settings("[preserve]\nwidth = 9\n") == SettingsUse::kPreserve);
    CHECK(use_of_settings("[run]\nseed = 1\n") == SettingsUse::kExperiment);
    CHECK(use_of_settings("") == SettingsUse::kExperiment);
    CHECK(use_of_settings("[preserve]\nwidth = ") == SettingsUse::kExperiment);
}

TEST_CASE("an empty settings file is the default experiment", "[persist][settings_file]") {
    const auto loaded = parse_settings("", "run.toml", kinds());
    REQUIRE(loaded);
    CHECK(*loaded == ExperimentSettings{});
}

TEST_CASE("whatever the settings, they are read back and written to the same bytes",
          "[persist][settings_file]") {
    RandomStream stream(81);
    const auto fields = setting_fields(kinds());
    int checked = 0;
    while (checked < test::by_build(200, 60)) {
        ExperimentSettings settings;
        for (const SettingField& field : fields)
            randomize(field, settings, stream);
        share_out(settings.breeding.shares);
        settings.world.trial.duration *= 1e-4;  // keeps most of them within the limit of work
        if (!check_settings(settings, kinds())) continue;  // the settings contradict one another
        ++checked;
        const std::string text = write_settings(settings, kinds());
        const auto loaded = parse_settings(text, "run.toml", kinds());
        REQUIRE(loaded);
        REQUIRE(*loaded == settings);
        REQUIRE(write_settings(*loaded, kinds()) == text);
    }
}

TEST_CASE("every setting is written with its range, default and meaning",
          "[persist][settings_file]") {
    const std::string text = write_settings(ExperimentSettings{}, kinds());
    CHECK_THAT(text, Catch::Contains("gravity = 9.81                # 0 to 1000 m/s^2; default "
                                     "9.81. The acceleration of free fall"));
    for (const SettingField& field : setting_fields(kinds())) {
        CHECK_THAT(text, Catch::Contains("\n[" + field.table + "]\n"));
        CHECK_THAT(text, Catch::Contains("\n" + field.key + " = "));
        CHECK_THAT(text, Catch::Contains(field.help));
    }
}

TEST_CASE("a file that only names the goal gets the goal's world", "[persist][settings_file]") {
    const auto loaded = parse_settings(
        "[goal]\nbehavior = \"swimming\"\n[environment]\ndensity = 2\n", "run.toml", kinds());
    REQUIRE(loaded);
    CHECK(loaded->world.environment.gravity == 0.0);
    CHECK_FALSE(loaded->world.environment.has_ground);
    CHECK(loaded->world.environment.density == 2.0);
}

TEST_CASE("a file that only names seeking gets light, senses and pairs of trials",
          "[persist][settings_file]") {
    const auto settings = parse_settings("[goal]\nbehavior = \"seeking\"\n", "it", kinds());
    REQUIRE(settings);
    CHECK(settings->world.environment.has_light);
    CHECK(settings->world.environment.light_motion == "jumping");
    CHECK(settings->world.trial.trials == 4);
    CHECK(settings->world.trial.duration == 25.0);
    CHECK(settings->world.trial.renewal == 10);
    CHECK(settings->founders.channels.at("light-along"));
    const auto dark = parse_settings(
        "[goal]\nbehavior = \"seeking\"\n[environment]\nlight = false\n", "it", kinds());
    REQUIRE_FALSE(dark);
    CHECK(dark.error().message ==
          "it: goal \"seeking\" has no light: set [environment] light = true");
    const auto wrong = parse_settings("[environment]\nlight-motion = \"dancing\"\n", "it", kinds());
    REQUIRE_FALSE(wrong);
    CHECK(wrong.error().message.find("light-motion") != std::string::npos);
    CHECK(wrong.error().message.find("wandering") != std::string::npos);
    const auto crossed = parse_settings("[environment]\nlight-farthest = 1\n", "it", kinds());
    REQUIRE_FALSE(crossed);
    CHECK(crossed.error().message ==
          "it: [environment] light-nearest: 3 is above light-farthest, which is 1");
}

TEST_CASE("digests of settings leave out younger settings at their default",
          "[persist][settings_file]") {
    ExperimentSettings settings;
    const std::string before = digested_settings(settings, kinds());
    CHECK(before.find("environment.gravity = 9.81\n") != std::string::npos);
    CHECK(before.find("light") == std::string::npos);
    CHECK(before.find("trial.draw") == std::string::npos);
    settings.founders.channels["light"] = false;
    CHECK(digested_settings(settings, kinds()) == before);
    settings.world.environment.light_reach = 3.0;
    CHECK(digested_settings(settings, kinds()).find("environment.light-reach = 3.0\n") !=
          std::string::npos);
}

TEST_CASE("a mistyped key is located and the right one offered", "[persist][settings_file]") {
    CHECK(message_of("[environment]\ngravty = 3\n") ==
          "run.toml: line 2, [environment] gravty: unknown key; did you mean \"gravity\"?");
    CHECK(message_of("[population]\nsurvival = 0.1\n") ==
          "run.toml: line 2, [population] survival: unknown key; did you mean [selection] "
          "survival?");
    CHECK(message_of("\n[enviroment]\ngravity = 3\n") ==
          "run.toml: line 2, [enviroment]: unknown table; did you mean [environment]?");
    CHECK(message_of("[mutation.wieghts]\nroot = 3\n") ==
          "run.toml: line 1, [mutation.wieghts]: unknown table; did you mean [mutation.weights]?");
    CHECK(message_of("gravity = 3\n") ==
          "run.toml: line 1, gravity: unknown key; did you mean [environment] gravity?");
}

TEST_CASE("a value of the wrong type is located", "[persist][settings_file]") {
    CHECK(message_of("[environment]\ngravity = \"heavy\"\n") ==
          "run.toml: line 2, [environment] gravity: expected a number, found a text");
    CHECK(message_of("[population]\nsize = 10.5\n") ==
          "run.toml: line 2, [population] size: expected a whole number, found a number");
    CHECK(message_of("[environment]\nground = 1\n") ==
          "run.toml: line 2, [environment] ground: expected true or false, found a whole number");
    CHECK(message_of("environment = 3\n") == "run.toml: line 1, environment: expected a table");
    CHECK_THAT(message_of("[environment]\ngravity = [1]\n"), Catch::Contains("expected a number"));
}

TEST_CASE("a value outside its range is located", "[persist][settings_file]") {
    CHECK(message_of("[environment]\n\ngravity = 2000\n") ==
          "run.toml: line 3, [environment] gravity: 2000 is outside [0, 1000] m/s^2");
    CHECK_THAT(message_of("[environment]\ngravity = nan\n"), Catch::Contains("nan is outside"));
    CHECK_THAT(message_of("[environment]\ngravity = inf\n"), Catch::Contains("inf is outside"));
    CHECK_THAT(message_of("[run]\nseed = -1\n"), Catch::Contains("-1 is outside"));
    CHECK_THAT(message_of("[population]\nsize = 9999999999999999\n"),
               Catch::Contains("is outside [2, 20000]"));
    CHECK_THAT(message_of("[goal]\nbehavior = \"swiming\"\n"),
               Catch::Contains("unknown \"swiming\"; did you mean \"swimming\"?"));
    CHECK_THAT(message_of("[goal]\nbehavior = \"juggling\"\n"),
               Catch::Contains("known are walking, "));
}

TEST_CASE("settings that contradict each other are refused", "[persist][settings_file]") {
    CHECK_THAT(message_of("[body]\nmin-nodes = 6\n"),
               Catch::Contains("run.toml: [body] min-nodes"));
    CHECK_THAT(message_of("[breeding]\nasexual = 0\ncrossover = 0\ngrafting = 0\n"),
               Catch::Contains("[breeding]"));
}

TEST_CASE("text that is no TOML is located by its line", "[persist][settings_file]") {
    CHECK_THAT(message_of("[run]\nseed = \n"), Catch::StartsWith("run.toml: line "));
    CHECK_THAT(message_of("{\"format\": \"cambrian-creature\"}"),
               Catch::StartsWith("run.toml: line 1"));
    CHECK_THAT(message_of("[run]\nseed = 1\nseed = 2\n"), Catch::StartsWith("run.toml: line 3"));
    CHECK_THAT(message_of("a = " + std::string(5000, '[')), Catch::StartsWith("run.toml: line 1"));
}

TEST_CASE("all faults of a file are listed at once", "[persist][settings_file]") {
    CHECK(message_of("[environment]\ngravity = -1\n[run]\nsed = 1\n") ==
          "run.toml: line 2, [environment] gravity: -1 is outside [0, 1000] m/s^2\n"
          "  line 4, [run] sed: unknown key; did you mean \"seed\"?");
}

TEST_CASE("an unknown function is an error that names the one meant", "[persist][settings_file]") {
    CHECK(message_of("[body.functions]\noscilate-wave = false\n") ==
          "run.toml: line 2, [body.functions] oscilate-wave: unknown key; did you mean "
          "\"oscillate-wave\"?");
    CHECK_THAT(
        message_of("[body.functions]\nfrobnicate = false\n"),
        Catch::StartsWith("run.toml: line 2, [body.functions] frobnicate: unknown key; known "
                          "are sum, product, ") &&
            Catch::EndsWith(", oscillate-wave, oscillate-saw"));
}

TEST_CASE("settings are saved to a file and loaded from it", "[persist][settings_file]") {
    const TemporaryDirectory folder;
    ExperimentSettings settings;
    settings.world.environment.gravity = 1.62;
    settings.breeding.shares = {{"asexual", 0.9}, {"crossover", 0.1}, {"grafting", 0.0}};
    settings.founders.functions["log"] = false;
    REQUIRE(save_settings(folder / "moon.toml", settings, kinds()));
    const auto loaded = load_settings(folder / "moon.toml", kinds());
    REQUIRE(loaded);
    CHECK(loaded->world == settings.world);
    CHECK(loaded->breeding.shares.at("asexual") == 0.9);
    CHECK_FALSE(loaded->founders.functions.at("log"));
    CHECK_THAT(load_settings(folder / "none.toml", kinds()).error().message,
               Catch::Contains("none.toml: No such file"));
}

TEST_CASE("a table without a name that can be read is an error at its place",
          "[persist][settings]") {
    for (const char* text : {"[=]\n", "[ = a]\n", "[a.=]\n", "[[=]]\n", "[\x01]\n", "[#]\n"}) {
        INFO(text);
        const auto settings = parse_settings(text, "odd.toml", kinds());
        REQUIRE_FALSE(settings);
        CHECK(settings.error().message.starts_with("odd.toml: "));
        CHECK(settings.error().message.find("line 1") != std::string::npos);
    }
}
