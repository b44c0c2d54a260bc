// One test per code of persist/README.md 2: a fault of a file and its message.

#include "persist/sample_creature.h"
#include "support/catch.h"
#include "support/temporary_directory.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

using namespace cambrian;
using namespace cambrian::test;

namespace {

// Returns the sample with the first occurrence of one text replaced by another.
std::string changed(std::string_view from, std::string_view to) {
    std::string text = sample_text();
    const std::size_t place = text.find(from);
    REQUIRE(place != std::string::npos);
    return text.replace(place, from.size(), to);
}

std::string message_of_creature(const std::string& text) {
    const auto loaded = parse_creature(text, "some.creature.json", kinds());
    return loaded ? "no error" : loaded.error().message;
}

std::vector<std::string> warnings_of(const std::string& text) {
    const auto loaded = parse_creature(text, "some.creature.json", kinds());
    REQUIRE(loaded);
    return loaded->warnings;
}

}  // namespace

TEST_CASE("E01: text that is no JSON is located by line and column", "[persist][creature_error]") {
    CHECK(message_of_creature("") == "some.creature.json: E01 the file is empty");
    CHECK_THAT(message_of_creature(changed("\"version\": 2,", "\"version\": 2")),
               Catch::Contains("E01 line 4, column ") && Catch::Contains("expected '}'"));
    CHECK_THAT(message_of_creature(changed("two-link", "two\xff-link")),
               Catch::Contains("E01 line 4"));
    CHECK_THAT(message_of_creature("# TOML\n[run]\n"), Catch::Contains("E01 line 1, column 1"));
    CHECK_THAT(message_of_creature(sample_text() + "}"), Catch::Contains("E01 line"));
    CHECK_THAT(message_of_creature("[]"), Catch::Contains("expected an object, found a list"));
}

TEST_CASE("E02: a file too large or too deep is refused", "[persist][creature_error]") {
    CHECK(message_of_creature(std::string(9'100'000, ' ')) ==
          "some.creature.json: E02 file too large: 9.1 MB, limit 4.0 MB");
    CHECK_THAT(message_of_creature(std::string(1000, '[')),
               Catch::Contains("E02 nested deeper than 32 levels"));
    std::string many = "[0";
    for (int i = 0; i < 200'000; ++i)
        many += ",0";
    CHECK_THAT(message_of_creature(many + "]"),
               Catch::Contains("E02") && Catch::Contains("100000 values"));
}

TEST_CASE("E03: a file of another kind is named", "[persist][creature_error]") {
    CHECK(message_of_creature(changed("cambrian-creature", "cambrian-settings")) ==
          "some.creature.json: E03 /format: this is a \"cambrian-settings\", expected "
          "\"cambrian-creature\"");
    CHECK(message_of_creature("{}") ==
          "some.creature.json: E03 /format: missing, expected \"cambrian-creature\"");
}

TEST_CASE("E04: a version from the future or none at all is refused", "[persist][creature_error]") {
    CHECK(message_of_creature(changed("\"version\": 2", "\"version\": 5")) ==
          "some.creature.json: E04 /version: 5 is newer than this program (4)");
    CHECK_THAT(message_of_creature(changed("\"version\": 2", "\"version\": 0")),
               Catch::Contains("E04"));
    CHECK_THAT(message_of_creature(changed("\"version\": 2", "\"version\": -1.5")),
               Catch::Contains("E04"));
    CHECK_THAT(message_of_creature(changed("\"version\": 2", "\"version\": \"1\"")),
               Catch::Contains("/version"));
}

TEST_CASE("E05: a missing key is pointed at", "[persist][creature_error]") {
    CHECK(message_of_creature(changed("\"width\": 0.2,", "")) ==
          "some.creature.json: E05 /nodes/0/width: missing");
    CHECK_THAT(message_of_creature(
                   changed("\"kind\": \"localNeuron\", \"k\": 0", "\"kind\": \"localNeuron\"")),
               Catch::Contains("E05 /nodes/1/effector/source/k: missing"));
}

TEST_CASE("E06: a value of the wrong type is shown", "[persist][creature_error]") {
    CHECK(message_of_creature(changed("\"length\": 0.5", "\"length\": \"long\"")) ==
          "some.creature.json: E06 /nodes/0/length: expected a number, found \"long\"");
    CHECK_THAT(message_of_creature(changed("\"symmetric\": false", "\"symmetric\": 0")),
               Catch::Contains("E06 /nodes/0/symmetric: expected true or false, found a number"));
    CHECK_THAT(message_of_creature(changed("\"recursionLimit\": 1", "\"recursionLimit\": 1.5")),
               Catch::Contains("E06 /nodes/0/recursionLimit: expected a whole number, found 1.5"));
    CHECK_THAT(message_of_creature(changed("\"limits\": [-1.0, 1.0]", "\"limits\": [-1.0]")),
               Catch::Contains("E06 /nodes/0/limits"));
}

TEST_CASE("E07: a number outside its range names the range", "[persist][creature_error]") {
    CHECK(message_of_creature(changed("[-1.0, 1.0]", "[0.4, 1.0]")) ==
          "some.creature.json: E07 /nodes/0/limits/0: 0.4 is outside [-2.6, -0.05]");
    CHECK_THAT(message_of_creature(changed("\"pos\": 0.125", "\"pos\": 1")),
               Catch::Contains("E07 /nodes/0/edges/0/pos: 1 is outside [0, 1)"));
    CHECK_THAT(message_of_creature(changed("\"length\": 0.5", "\"length\": 1e999")),
               Catch::Contains("E07 /nodes/0/length: 1e999 is not a finite number"));
    CHECK_THAT(message_of_creature(changed("\"gravity\": 9.81", "\"gravity\": -1")),
               Catch::Contains("E07 /scored/environment/gravity: -1 is outside [0, 1000] m/s^2"));
    CHECK_THAT(message_of_creature(changed("\"length\": 0.5", "\"length\": NaN")),
               Catch::Contains("E01"));
}

TEST_CASE("E07: the world of a creature without a score is checked as that of a trial",
          "[persist][creature_error]") {
    CreatureDocument document = sample_document();
    drop_score(document);
    change_settings(document.creature, [](ExperimentSettings& settings) {
        settings.world.environment.gravity = 1.62;
    });
    std::string text = write_creature(document, kinds());
    CHECK(message_of_creature(text) == "no error");
    const std::string gravity = "\"gravity\": 1.62";
    text.replace(text.find(gravity), gravity.size(), "\"gravity\": -1");
    CHECK_THAT(message_of_creature(text),
               Catch::Contains("E07 /world/environment/gravity: -1 is outside [0, 1000] m/s^2"));
    change_settings(document.creature, [](ExperimentSettings& settings) {
        settings.world.trial.duration = 3000.0;
        settings.world.trial.trials = 4;
    });
    CHECK_THAT(message_of_creature(write_creature(document, kinds())),
               Catch::Contains("E07 /world/trial: 4 trials of 3000 s"));
}

TEST_CASE("E07: a creature whose trials ask for hours of computing is refused",
          "[persist][creature_error]") {
    CreatureDocument document = sample_document();
    const auto set_trials = [&](int trials) {
        change_settings(document.creature, [&](ExperimentSettings& settings) {
            settings.world.trial.duration = 3000.0;
            settings.world.trial.trials = trials;
        });
    };
    set_trials(1);
    const auto load = [&] { return message_of_creature(write_creature(document, kinds())); };
    CHECK(load() == "no error");
    set_trials(4);
    CHECK(load() ==
          "some.creature.json: E07 /scored/trial: 4 trials of 3000 s, 12000 s in all; "
          "limit 10000 s");
    set_trials(3);
    CHECK_THAT(load(),
               Catch::Contains("E07 /scored/trial: 3 trials of 3000 s and 3 s of settling") &&
                   Catch::EndsWith(" in all; limit 200000000"));
}

TEST_CASE("E08: an unknown name brings the nearest known one", "[persist][creature_error]") {
    CHECK(message_of_creature(changed("oscillate-wave", "oscilate-wave")) ==
          "some.creature.json: E08 /nodes/1/neurons/0/fn: unknown function \"oscilate-wave\"; did "
          "you mean \"oscillate-wave\"?");
    CHECK_THAT(message_of_creature(changed("\"across\"", "\"acros\"")),
               Catch::Contains("E08 /nodes/1/mirrorAxis: unknown axis \"acros\""));
    CHECK_THAT(message_of_creature(changed("\"contact-left\"", "\"contact-lef\"")),
               Catch::Contains("unknown sensor channel \"contact-lef\"; did you mean "
                               "\"contact-left\"?"));
    CHECK_THAT(message_of_creature(changed("\"contact-left\"", "256")),
               Catch::Contains("E07 /brain/0/in/0/from/ch: 256 is outside [0, 255]"));
    CHECK_THAT(
        message_of_creature(changed("\"behavior\": \"walking\"", "\"behavior\": \"walkin\"")),
        Catch::Contains("E08 /scored/goal/behavior"));
}

TEST_CASE("E09: a target beyond the nodes counts them", "[persist][creature_error]") {
    CHECK(message_of_creature(changed("\"target\": 1", "\"target\": 7")) ==
          "some.creature.json: E09 /nodes/0/edges/0/target: 7, but there are 2 nodes");
    CHECK_THAT(message_of_creature(changed("\"target\": 1", "\"target\": -1")),
               Catch::Contains("E09"));
    CHECK_THAT(message_of_creature(changed("\"target\": 1", "\"target\": 1e18")),
               Catch::Contains("E09"));
}

TEST_CASE("E10: a list too long or too short says its limit", "[persist][creature_error]") {
    std::string nodes = "{";
    for (int i = 0; i < 40; ++i)
        nodes += "}, {";
    CHECK_THAT(message_of_creature(changed("\"nodes\": [", "\"nodes\": [" + nodes + "},")),
               Catch::Contains("E10 /nodes: 43 entries, limit 16"));
    CHECK_THAT(message_of_creature(changed("two-link crawler", std::string(65, 'x'))),
               Catch::Contains("E10 /name: 65 bytes, limit 64"));
    CHECK_THAT(
        message_of_creature("{\"format\": \"cambrian-creature\", \"version\": 1, \"nodes\": [], "
                            "\"brain\": []}"),
        Catch::Contains("E10 /nodes: 0 entries, at least 1"));
}

TEST_CASE("E11: a neuron with too few inputs says what it needs", "[persist][creature_error]") {
    CHECK(message_of_creature(changed("\"fn\": \"abs\"", "\"fn\": \"if\"")) ==
          "some.creature.json: E11 /brain/0/in: function \"if\" needs 3 inputs, found 1");
}

TEST_CASE("E12: a source in the wrong place says where it belongs", "[persist][creature_error]") {
    CHECK(message_of_creature(
              changed("\"kind\": \"partSensor\", \"n\": 1, \"i\": 1, \"ch\": \"contact-left\"",
                      "\"kind\": \"parentNeuron\", \"k\": 0")) ==
          "some.creature.json: E12 /brain/0/in/0/from/kind: \"parentNeuron\" is only for part "
          "neurons");
}

TEST_CASE("E13: a key that appears twice is named", "[persist][creature_error]") {
    CHECK(message_of_creature(changed("\"length\": 0.5,", "\"length\": 0.5, \"length\": 0.6,")) ==
          "some.creature.json: E13 /nodes/0: key \"length\" appears twice");
}

TEST_CASE("what is wrong with an organ is said in one message", "[persist][creature_error]") {
    const std::string sound = write_creature(with_organs(sample_document()), kinds());
    const auto message_after = [&](std::string_view from, std::string_view to) {
        std::string text = sound;
        const std::size_t place = text.find(from);
        REQUIRE(place != std::string::npos);
        return message_of_creature(text.replace(place, from.size(), to));
    };
    CHECK(message_after("\"kind\": \"sound\"", "\"kind\": \"soud\"") ==
          "some.creature.json: E08 /nodes/1/organs/0/kind: unknown organ \"soud\"; did you mean "
          "\"sound\"?");
    CHECK(message_after("\"band\": 2", "\"band\": 4") ==
          "some.creature.json: E07 /nodes/1/organs/0/band: 4 is outside [0, 3]");
    CHECK(message_after("\"band\": 2", "\"band\": 1.5") ==
          "some.creature.json: E06 /nodes/1/organs/0/band: expected a whole number, found 1.5");
    CHECK(message_after(", \"band\": 2", "") ==
          "some.creature.json: E05 /nodes/1/organs/0/band: missing");
    CHECK(message_after("\"kind\": \"childSensor\", \"e\": 3",
                        "\"kind\": \"childSensor\", \"e\": 16") ==
          "some.creature.json: E07 /nodes/1/organs/1/source/e: 16 is outside [0, 15]");
    CHECK(message_after("\"kind\": \"childSensor\", \"e\": 3, \"ch\": \"joint\"",
                        "\"kind\": \"partNeuron\", \"n\": 0, \"i\": 0, \"k\": 0") ==
          "some.creature.json: E12 /nodes/1/organs/1/source/kind: \"partNeuron\" is only for "
          "central neurons");
    CHECK(message_after("\"organs\": [", "\"organs\": [ {}, {},") ==
          "some.creature.json: E10 /nodes/1/organs: 4 entries, limit 3");
}

TEST_CASE("what is wrong with a deformer is said in one message", "[persist][creature_error]") {
    const std::string fine = R"("kind": "deformer", "source": { "kind": "const" }, "weight": 1, )"
                             R"("low": -0.4, "high": 0.3)";
    const auto message_with = [&](const std::string& organs) {
        return message_of_creature(
            changed("\"neurons\":", "\"organs\": [ " + organs + " ], \"neurons\":"));
    };
    const auto deformer = [&](std::string_view from, std::string_view to) {
        std::string text = fine;
        const std::size_t place = text.find(from);
        REQUIRE(place != std::string::npos);
        return "{ " + text.replace(place, from.size(), to) + " }";
    };
    CHECK(message_with(deformer("-0.4", "0.4")) ==
          "some.creature.json: E07 /nodes/0/organs/0/low: 0.4 is outside [-0.5, -0.05]");
    CHECK(message_with(deformer("0.3", "-0.3")) ==
          "some.creature.json: E07 /nodes/0/organs/0/high: -0.3 is outside [0.05, 0.5]");
    CHECK(message_with(deformer("\"deformer\"", "\"deformed\"")) ==
          "some.creature.json: E08 /nodes/0/organs/0/kind: unknown organ \"deformed\"; did you "
          "mean \"deformer\"?");
    CHECK(message_with("{ " + fine + " }, { " + fine + " }") ==
          "some.creature.json: E10 /nodes/0/organs: over 1 entry \"deformer\", limit 1");
}

TEST_CASE("several errors come together, the first with the file's name",
          "[persist][creature_error]") {
    std::string text = changed("\"length\": 0.5", "\"length\": 9");
    text.replace(text.find("\"target\": 1"), 11, "\"target\": 5");
    CHECK(message_of_creature(text) ==
          "some.creature.json: E07 /nodes/0/length: 9 is outside [0.08, 1.6]\n"
          "  E09 /nodes/0/edges/0/target: 5, but there are 2 nodes");
}

TEST_CASE("after twenty errors no more are listed", "[persist][creature_error]") {
    std::string nodes = "[{}";
    for (int i = 0; i < 10; ++i)
        nodes += ", {}";
    const std::string message = message_of_creature(
        "{\"format\": \"cambrian-creature\", \"version\": 1, \"nodes\": " + nodes +
        "], \"brain\": []}");
    CHECK(std::count(message.begin(), message.end(), '\n') == 20);
    CHECK_THAT(message, Catch::EndsWith("no more errors are looked for after 20"));
}

TEST_CASE("W01: an unknown key is ignored with a warning", "[persist][creature_error]") {
    const auto warnings = warnings_of(changed("\"uid\": 1,", "\"uid\": 1, \"colour\": \"red\","));
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0] == "W01 /nodes/0/colour: unknown key, ignored");
}

TEST_CASE("W02: a node nobody can reach is removed with a warning", "[persist][creature_error]") {
    const std::string text = changed("\"target\": 1", "\"target\": 0");
    const auto loaded = parse_creature(text, "some.creature.json", kinds());
    REQUIRE(loaded);
    CHECK(loaded->genome().nodes.size() == 1);
    REQUIRE(loaded->warnings.size() == 2);
    CHECK(loaded->warnings[0] == "W02 /nodes: 1 node cannot be reached from the root, removed");
}

TEST_CASE("W03: a creature changed by hand is loaded with a warning", "[persist][creature_error]") {
    const auto warnings = warnings_of(changed("\"length\": 0.5", "\"length\": 0.6"));
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Catch::StartsWith("W03 /check"));
}

TEST_CASE("W05: a creature's number that is none is ignored with a warning",
          "[persist][creature_error]") {
    const auto loaded = parse_creature(changed("\"88d1c00000000002\"", "\"mother\""),
                                       "some.creature.json", kinds());
    REQUIRE(loaded);
    REQUIRE(loaded->warnings.size() == 1);
    CHECK(loaded->warnings[0] ==
          "W05 /parents/1: is not a number of 1 to 16 hexadecimal digits, ignored");
    CHECK(loaded->creature.individual->parents ==
          std::array<std::uint64_t, 2>{0x17aa040000000001ULL, 0});
}

TEST_CASE("a creature file of 100 MB is refused unread", "[persist][creature_error]") {
    const TemporaryDirectory folder;
    put_text(folder / "huge.creature.json", "{");
    std::filesystem::resize_file(folder / "huge.creature.json", 100'000'000);
    const auto loaded = load_creature(folder / "huge.creature.json", kinds());
    REQUIRE_FALSE(loaded);
    CHECK_THAT(loaded.error().message,
               Catch::EndsWith("huge.creature.json: file too large: 100.0 MB, limit 4.0 MB"));
}
