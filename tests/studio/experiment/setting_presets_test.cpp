#include "studio/experiment/setting_presets.h"

#include "studio/experiment/settings_editor.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <algorithm>
#include <set>

namespace cambrian {
namespace {

const std::vector<SettingField>& preset_fields() {
    static const std::vector<SettingField> all = setting_fields(test::kinds());
    return all;
}

std::vector<std::string> in_force(std::string_view table, const ExperimentSettings& settings) {
    std::vector<std::string> labels;
    for (const SettingPreset& preset : setting_presets(table)) {
        if (is_in_force(preset, settings, test::kinds(), preset_fields()))
            labels.emplace_back(preset.label);
    }
    return labels;
}

TEST_CASE("the presets of all tables are valid and the only ones in force once applied",
          "[studio][presets]") {
    std::size_t listed = 0;
    std::set<std::string_view> tables;
    for (const SettingPreset& preset : setting_presets()) {
        ExperimentSettings settings;
        settings.world.environment.density = 2.0;
        preset.apply(settings, test::kinds());
        INFO(preset.label);
        CHECK(check_settings(settings, test::kinds()).has_value());
        CHECK(settings.world.environment.density == 2.0);
        CHECK(in_force(preset.table, settings) == std::vector<std::string>{preset.label});
        if (tables.insert(preset.table).second) listed += setting_presets(preset.table).size();
        CHECK(std::any_of(preset_fields().begin(), preset_fields().end(),
                          [&](const SettingField& field) { return field.table == preset.table; }));
    }
    CHECK(listed == setting_presets().size());
    CHECK(setting_presets("run").empty());
}

TEST_CASE("presets change nothing outside their table", "[studio][presets]") {
    for (const SettingPreset& preset : setting_presets()) {
        ExperimentSettings before;
        before.world.trial.trials = 9;
        before.world.environment.friction = 0.123;
        before.mutation.weights["weight"] = 123.0;
        ExperimentSettings after = before;
        preset.apply(after, test::kinds());
        for (const SettingField& field : preset_fields()) {
            if (field.table.starts_with(preset.table)) continue;
            INFO(preset.label << ": " << field.table << "." << field.key);
            CHECK(same_value(field, before, after));
        }
    }
}

TEST_CASE("the default settings are those of a preset, other values of none", "[studio][presets]") {
    ExperimentSettings settings;
    CHECK(in_force("environment", settings) == std::vector<std::string>{"Earth"});
    CHECK(in_force("mutation", settings) == std::vector<std::string>{"Body and brain"});
    CHECK(in_force("trial", settings) == std::vector<std::string>{"One trial"});
    settings.world.environment.friction = 0.33;
    settings.mutation.weights["weight"] = 19.0;
    settings.world.trial.trials = 2;
    for (const char* table : {"environment", "mutation", "trial"})
        CHECK(in_force(table, settings).empty());
}

}  // namespace
}  // namespace cambrian
