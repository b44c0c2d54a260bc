#include "evolution/fields/setting_words.h"

#include "support/catch.h"
#include "support/kinds.h"

#include <algorithm>
#include <set>

namespace cambrian {
namespace {

TEST_CASE("every word belongs to a setting, and no two settings share one",
          "[evolution][setting_words]") {
    std::set<std::string> paths = {"environment"};
    for (const SettingField& field : setting_fields(test::kinds()))
        paths.insert(path_of(field));
    std::set<std::string_view> words;
    for (const SettingWords& each : all_setting_words()) {
        INFO(each.path);
        CHECK(paths.contains(std::string(each.path)));
        CHECK((!each.word.empty() || !each.hint.empty()));
        if (!each.word.empty()) CHECK(words.insert(each.word).second);
    }
}

TEST_CASE("a word stands before the term of the field, which stays", "[evolution][setting_words]") {
    SettingField field;
    field.table = "environment";
    field.key = "elasticity";
    field.label = "Restitution";
    field.help = "The coefficient.";
    CHECK(plain_label(field) == "Bounciness (restitution)");
    CHECK(plain_help(field).find("bounces") != std::string::npos);
    field.key = "unheard-of";
    CHECK(plain_label(field) == "Restitution");
    CHECK(plain_help(field) == "The coefficient.");
    CHECK(words_text(setting_fields(test::kinds())).find("| Grip | Friction |") !=
          std::string::npos);
}

}  // namespace
}  // namespace cambrian
