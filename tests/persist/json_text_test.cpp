#include "persist/json/json_text.h"

#include "persist/text/quoted_text.h"
#include "support/catch.h"

using namespace cambrian;

TEST_CASE("an object is written in every layout", "[persist][json]") {
    const JsonMembers members = {{"a", "1"}, {"b", quoted_text("x\n")}};
    CHECK(json_object(members) == R"({"a": 1, "b": "x\u000a"})");
    CHECK(json_object(members, JsonLayout::kDense) == R"({"a":1,"b":"x\u000a"})");
    CHECK(json_object(members, JsonLayout::kCompact) == R"({ "a": 1, "b": "x\u000a" })");
    CHECK(json_object(members, JsonLayout::kLines) == "{\n  \"a\": 1,\n  \"b\": \"x\\u000a\"\n}");
    CHECK(json_object({}) == "{}");
    CHECK(json_list({"1", "2"}) == "[1, 2]");
    CHECK(json_list({"1", "2"}, JsonLayout::kDense) == "[1,2]");
}

TEST_CASE("a list inside has the layout of what surrounds it unless that is lines",
          "[persist][json]") {
    const auto nested = [](JsonLayout outer, JsonLayout inner) {
        std::string text;
        JsonText json(text);
        json.open('{', outer);
        json.begin_item("in");
        json.open('[', inner);
        json.item("", "1");
        json.item("", "2");
        json.close(']');
        json.close('}');
        return text;
    };
    CHECK(nested(JsonLayout::kDense, JsonLayout::kLines) == R"({"in":[1,2]})");
    CHECK(nested(JsonLayout::kCompact, JsonLayout::kLines) == R"({ "in": [ 1, 2 ] })");
    CHECK(nested(JsonLayout::kLines, JsonLayout::kLine) == "{\n  \"in\": [1, 2]\n}");
}
