#include "studio/experiment/setting_filter.h"

#include "support/catch.h"
#include "support/kinds.h"

namespace cambrian {
namespace {

std::vector<std::string> found(const char* words) {
    std::vector<std::string> names;
    const SettingFilter filter(words);
    for (const SettingField& field : setting_fields(test::kinds())) {
        if (filter.finds(field, "Group of " + field.table))
            names.push_back(field.table + "." + field.key);
    }
    return names;
}
bool holds(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

TEST_CASE("settings are found by name, in any case, by all words", "[studio][setting_filter]") {
    CHECK(SettingFilter("  ").empty());
    CHECK(holds(found("GRAV"), "environment.gravity"));
    CHECK_FALSE(holds(found("grav"), "environment.friction"));
    CHECK(holds(found("group environment gravity"), "environment.gravity"));
    CHECK(found("gravity xylophone").empty());
}

TEST_CASE("settings are found by words of their help", "[studio][setting_filter]") {
    for (const SettingField& field : setting_fields(test::kinds())) {
        REQUIRE_FALSE(field.help.empty());
        CHECK(holds(found(field.help.c_str()), field.table + "." + field.key));
    }
}

TEST_CASE("every setting has a description and a range, choices or a format",
          "[studio][setting_filter]") {
    ExperimentSettings defaults;
    for (const SettingField& field : setting_fields(test::kinds())) {
        INFO(field.table << "." << field.key);
        CHECK_FALSE(field.label.empty());
        const SettingRef ref = field.at(defaults);
        if (std::holds_alternative<std::string*>(ref)) {
            CHECK((field.choices.size() > 1 || !field.format.empty()));
        } else if (!std::holds_alternative<bool*>(ref)) {
            CHECK(field.high > field.low);
        }
    }
}

}  // namespace
}  // namespace cambrian
