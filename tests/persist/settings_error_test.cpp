// The errors of a settings file. Each message names the file, the line, the key, what was expected
// and the nearest known name, if there is one.

#include "evolution/fields/setting_field.h"
#include "persist/settings/settings_file.h"
#include "persist/settings_message.h"
#include "support/catch.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

#include <algorithm>
#include <variant>

using namespace cambrian;
using namespace cambrian::test;

namespace {

std::string with_value(const SettingField& field, const std::string& value) {
    return "[" + field.table + "]\n" + field.key + " = " + value + "\n";
}

// Returns the start of a message: "run.toml: line 2, [table] key: ".
std::string place_of(const SettingField& field) {
    return "run.toml: line 2, [" + field.table + "] " + field.key + ": ";
}

enum class Sort { kFlag, kWhole, kReal, kText };
Sort sort_of(const SettingField& field) {
    ExperimentSettings settings;
    const SettingRef place = field.at(settings);
    if (std::holds_alternative<bool*>(place)) return Sort::kFlag;
    if (std::holds_alternative<std::string*>(place)) return Sort::kText;
    return std::holds_alternative<double*>(place) ? Sort::kReal : Sort::kWhole;
}

std::string expected_of(const SettingField& field) {
    switch (sort_of(field)) {
        case Sort::kFlag:
            return "expected true or false";
        case Sort::kText:
            return "expected a text";
        case Sort::kReal:
            return "expected a number";
        default:
            return "expected a whole number";
    }
}

}  // namespace

TEST_CASE("every setting refuses what is of no type of its own", "[persist][settings_error]") {
    for (const SettingField& field : setting_fields(kinds())) {
        for (const char* value :
             {"[1]", "[]", "{}", "{ a = 1 }", "1979-05-27", "07:32:00", "1979-05-27T07:32:00Z"}) {
            INFO(field.table << "." << field.key << " = " << value);
            CHECK_THAT(message_of(with_value(field, value)),
                       Catch::StartsWith(place_of(field) + expected_of(field)));
        }
        if (sort_of(field) != Sort::kText) {
            CHECK_THAT(message_of(with_value(field, "\"1\"")),
                       Catch::StartsWith(place_of(field) + expected_of(field)));
        }
        if (sort_of(field) == Sort::kText) {
            CHECK_THAT(message_of(with_value(field, "7")),
                       Catch::StartsWith(place_of(field) + expected_of(field)));
        }
        if (sort_of(field) != Sort::kFlag) {
            CHECK_THAT(message_of(with_value(field, "true")),
                       Catch::StartsWith(place_of(field) + expected_of(field)));
        }
    }
}

TEST_CASE("every number outside its range names the range", "[persist][settings_error]") {
    for (const SettingField& field : setting_fields(kinds())) {
        if (sort_of(field) == Sort::kReal) {
            for (const char* value : {"nan", "-nan", "inf", "-inf", "1e300", "-1e300"}) {
                INFO(field.table << "." << field.key << " = " << value);
                const std::string message = message_of(with_value(field, value));
                CHECK_THAT(message, Catch::StartsWith(place_of(field)));
                CHECK_THAT(message, Catch::Contains(" is outside ["));
            }
        }
        if (sort_of(field) == Sort::kWhole) {
            for (const char* value :
                 {"9223372036854775807", "-9223372036854775808", "-1", "0x7fffffffffffffff"}) {
                INFO(field.table << "." << field.key << " = " << value);
                const std::string message = message_of(with_value(field, value));
                CHECK_THAT(message, Catch::StartsWith(place_of(field)));
                CHECK_THAT(message, Catch::Contains(" is outside ["));
            }
        }
    }
}

TEST_CASE("every mistyped key brings the right one", "[persist][settings_error]") {
    for (const SettingField& field : setting_fields(kinds())) {
        std::string typo = field.key;
        typo.insert(typo.size() / 2, "x");
        INFO(field.table << "." << typo);
        const std::string message = message_of("[" + field.table + "]\n" + typo + " = 1\n");
        CHECK_THAT(message, Catch::StartsWith("run.toml: line 2, [" + field.table + "] " + typo +
                                              ": unknown key; did you mean \""));
        CHECK_THAT(message, Catch::EndsWith("\"" + field.key + "\"?"));
    }
}

TEST_CASE("every unknown choice brings the nearest or all of them", "[persist][settings_error]") {
    for (const SettingField& field : setting_fields(kinds())) {
        if (sort_of(field) != Sort::kText || field.choices.empty()) continue;
        const std::string near = message_of(with_value(field, "\"" + field.choices[0] + "x\""));
        CHECK_THAT(near, Catch::StartsWith(place_of(field) + "unknown \""));
        CHECK_THAT(near, Catch::Contains("did you mean \"" + field.choices[0] + "\"?"));
        const std::string far = message_of(with_value(field, "\"qqqqqqqqqqqqqqqqqqqqqqqq\""));
        for (const std::string& choice : field.choices)
            CHECK_THAT(far, Catch::Contains(choice));
    }
}

TEST_CASE("text that is no TOML is refused at its line", "[persist][settings_error]") {
    for (const char* text :
         {"\n[run]\nseed = 1e999999\nx", "[run]\n\nseed = 99999999999999999999\n",
          "[run]\n\nseed = 01\n", "[run]\nseed = 1\nseed = 2\n", "[run]\n\n[run]\n",
          "[run]\n\nseed 1\n", "[run]\n\nseed = 1 2\n", "[run]\n\nseed = \"abc\n",
          "[run]\n\nseed = [1, 2\n", "[run]\n\nseed = {a = 1\n", "[run]\n\nseed = 1979-13-45\n",
          "[run]\n\n\n\xff = 1\n", "[run]\n\nname = \"\xc0\xaf\"\n",
          "[run]\n\nname = \"\\ud800\"\n", "[run]\n\nname = \"\\U00110000\"\n",
          "[run]\n\n[run.seed]\n[run.seed]\n", "[run]\n\nseed.a = 1\nseed.a = 2\n"}) {
        INFO(text);
        const std::string message = message_of(text);
        CHECK((message.starts_with("run.toml: line 3") || message.starts_with("run.toml: line 4")));
    }
    CHECK_THAT(message_of(std::string_view("[run]\nseed = 1\0\n", 17)),
               Catch::StartsWith("run.toml: line 2"));
    CHECK_THAT(message_of("\xff\xfe[\0r\0"), Catch::StartsWith("run.toml: line 1"));
}

TEST_CASE("a byte order mark and Windows line ends do no harm", "[persist][settings_error]") {
    CHECK(message_of("\xef\xbb\xbf[run]\r\nseed = 7\r\n") == "no error");
    CHECK(message_of("[run]\r\nsed = 7\r\n") ==
          "run.toml: line 2, [run] sed: unknown key; did you mean \"seed\"?");
}

TEST_CASE("nested tables are settings by their full name or unknown", "[persist][settings_error]") {
    CHECK_THAT(message_of("mutation.weights.wings = 3\n"),
               Catch::StartsWith("run.toml: line 1, [mutation.weights] wings: unknown key"));
    CHECK(message_of("environment = { gravity = 3 }\n") == "no error");
    CHECK(message_of("environment.gravity = 3\n") == "no error");
    CHECK_THAT(message_of("[environment.gravity]\na = 1\n"),
               Catch::StartsWith("run.toml: line 1, [environment] gravity: expected a number"));
    CHECK_THAT(message_of("[[environment]]\ngravity = 3\n"),
               Catch::StartsWith("run.toml: line 1, environment: expected a table"));
    CHECK_THAT(message_of("[environment.air]\ngravity = 3\n"),
               Catch::StartsWith("run.toml: line 1, [environment.air]: unknown table"));
    CHECK_THAT(message_of("[body.functions.sum]\na = 3\n"),
               Catch::StartsWith("run.toml: line 1, [body.functions] sum: expected true or false"));
    CHECK_THAT(message_of("\"\" = 1\n"), Catch::StartsWith("run.toml: line 1, : unknown key"));
}

TEST_CASE("a settings file of too many faults lists twenty of them", "[persist][settings_error]") {
    std::string text;
    for (int i = 0; i < 10000; ++i)
        text += "k" + std::to_string(i) + " = 1\n";
    const std::string message = message_of(text);
    CHECK(std::count(message.begin(), message.end(), '\n') == 20);
    CHECK_THAT(message, Catch::EndsWith("no more errors are looked for after 20"));
}

TEST_CASE("a settings file over a megabyte is refused unread", "[persist][settings_error]") {
    const TemporaryDirectory folder;
    put_text(folder / "huge.toml", std::string(1'000'001, '#'));
    const auto loaded = load_settings(folder / "huge.toml", kinds());
    REQUIRE_FALSE(loaded);
    CHECK_THAT(loaded.error().message,
               Catch::EndsWith("huge.toml: file too large: 1.0 MB, limit 1.0 MB"));
}

TEST_CASE("nesting is refused before the text is parsed", "[persist][settings_error]") {
    const auto repeated = [](const std::string& piece, std::size_t times) {
        std::string text;
        for (std::size_t i = 0; i < times; ++i)
            text += piece;
        return text;
    };
    constexpr std::size_t kMany = 100'000;  // of them, functions that call themselves need 100 MB
    for (const std::string& text : {
             "a" + repeated(".a", kMany) + " = 1\n",
             "a" + repeated(" . \"a\"", kMany) + " = 1\n",
             "'a'" + repeated(".'a'", kMany) + " = 1\n",
             "[a" + repeated(".a", kMany) + "]\n",
             "[[a" + repeated(".a", kMany) + "]]\n",
             "a = " + repeated("[", kMany),
             "a = " + repeated("{ a = ", kMany),
             "a = " + repeated("{a.a.a=", kMany),
             "a = { b" + repeated(".b", kMany) + " = 1 }\n",
             "a = [ 1, { b" + repeated(".b", kMany) + " = 1 } ]\n",
             "\xef\xbb\xbf[a" + repeated(".a", kMany) + "]\n",
         }) {
        INFO(text.substr(0, 40));
        CHECK_THAT(message_of(text),
                   Catch::StartsWith("run.toml: line 1: nested deeper than 32 levels"));
    }
    CHECK_THAT(message_of("# a.a\n\n[a]\nb" + repeated(".a", 32) + " = 1\n"),
               Catch::StartsWith("run.toml: line 4: nested deeper than 32 levels"));
    // What only looks like nesting is read.
    const std::string dots = repeated(".", 1000) + repeated("[{", 1000);
    for (const std::string& text :
         {"# " + dots, "# a\n  # " + dots, "x = \"" + dots + "\"", "x = \"\\\"" + dots + "\"",
          "x = '" + dots + "\\'", "x = \"\"\"\n\"" + dots + "\"\"\"\"\"",
          "x = \"\"\"\\\"\"\"" + dots + "\"\"\"", "x = '''\n'" + dots + "''''",
          "x = \"\" # " + dots, "x = [" + repeated("0.5,", 1000) + "]", repeated("[a.b]\n", 1)}) {
        INFO(text.substr(0, 40));
        CHECK_THAT(message_of(text), !Catch::Contains("nested"));
    }
    CHECK_THAT(message_of("x = \"\"\"a\"\"\"\"\"\ny" + repeated(".y", 40) + " = 1"),
               Catch::Contains("line 2: nested deeper"));
}

TEST_CASE("a text of any size is refused before it is parsed", "[persist][settings_error]") {
    CHECK_THAT(message_of(std::string(1'000'001, ' ')),
               Catch::StartsWith("run.toml: line 1: the text has 1000001 bytes, at most 1000000"));
}
