#include "studio/experiment/settings_editor.h"

#include "support/catch.h"
#include "support/kinds.h"

#include <algorithm>

namespace cambrian {
namespace {

ExperimentSettings with_gravity(double gravity) {
    ExperimentSettings settings;
    settings.world.environment.gravity = gravity;
    return settings;
}
double gravity_of(const SettingsEditor& editor) {
    return editor.draft().world.environment.gravity;
}

TEST_CASE("undo brings back the settings before an edit and redo those after it",
          "[studio][settings_editor]") {
    SettingsEditor editor{ExperimentSettings{}};
    editor.edit(with_gravity(1.62), "environment.gravity");
    editor.undo();
    CHECK(gravity_of(editor) == 9.81);
    CHECK_FALSE(editor.can_undo());
    editor.redo();
    CHECK(gravity_of(editor) == 1.62);
    CHECK_FALSE(editor.can_redo());
}

TEST_CASE("a drag of one control is one step to undo", "[studio][settings_editor]") {
    SettingsEditor editor{ExperimentSettings{}};
    for (int i = 1; i <= 50; ++i)
        editor.edit(with_gravity(9.81 - 0.1 * i), "environment.gravity");
    editor.finish();
    editor.undo();
    CHECK(gravity_of(editor) == 9.81);
}

TEST_CASE("two drags of one control are two steps", "[studio][settings_editor]") {
    SettingsEditor editor{ExperimentSettings{}};
    editor.edit(with_gravity(5.0), "environment.gravity");
    editor.finish();
    editor.edit(with_gravity(3.0), "environment.gravity");
    editor.undo();
    CHECK(gravity_of(editor) == 5.0);
}

TEST_CASE("an edit after undo forgets what could be redone", "[studio][settings_editor]") {
    SettingsEditor editor{ExperimentSettings{}};
    editor.edit(with_gravity(5.0), "environment.gravity");
    editor.undo();
    editor.edit(with_gravity(3.0), "environment.gravity");
    CHECK_FALSE(editor.can_redo());
}

TEST_CASE("an edit that changes nothing is no step to undo", "[studio][settings_editor]") {
    SettingsEditor editor{ExperimentSettings{}};
    editor.edit(ExperimentSettings{}, "environment.gravity");
    CHECK_FALSE(editor.can_undo());
}

TEST_CASE("a running experiment takes the live fields only", "[studio][settings_editor]") {
    const auto fields = setting_fields(test::kinds());
    ExperimentSettings draft = with_gravity(1.62);
    draft.seed = 77;
    draft.expression.max_parts = 9;
    const ExperimentSettings running;
    const ExperimentSettings next = with_live_fields(running, draft, fields);
    CHECK(next.world.environment.gravity == 1.62);
    CHECK(next.seed == running.seed);
    CHECK(next.expression == running.expression);
    const auto waiting = structural_changes(running, draft, fields);
    CHECK(waiting == std::vector<std::string>{"Seed", "Parts at most"});
}

TEST_CASE("every field's value can be copied and compared", "[studio][settings_editor]") {
    ExperimentSettings standard;
    for (const SettingField& field : setting_fields(test::kinds())) {
        ExperimentSettings changed;
        const SettingRef ref = field.at(changed);
        if (auto* const* flag = std::get_if<bool*>(&ref)) **flag = !**flag;
        if (auto* const* whole = std::get_if<int*>(&ref)) **whole += 1;
        if (auto* const* seed = std::get_if<std::uint64_t*>(&ref)) **seed += 1;
        if (auto* const* number = std::get_if<double*>(&ref)) **number += 0.5;
        if (auto* const* text = std::get_if<std::string*>(&ref)) **text += "?";
        INFO(field.table << "." << field.key);
        CHECK_FALSE(same_value(field, changed, standard));
        copy_value(field, standard, changed);
        CHECK(same_value(field, changed, standard));
    }
}

TEST_CASE("values are told in the words of the controls", "[studio][settings_editor]") {
    ExperimentSettings settings;
    settings.world.environment.gravity = 1.62;
    settings.world.environment.has_ground = false;
    settings.population.size = 1250;
    settings.selection.method = "map-elites";
    const auto text_of = [&](const std::string& path) {
        for (const SettingField& field : setting_fields(test::kinds())) {
            if (path_of(field) == path) return value_text(field, field.at(settings));
        }
        return std::string("no such setting");
    };
    CHECK(text_of("environment.gravity") == "1.62 m/s²");
    CHECK(text_of("environment.ground") == "off");
    CHECK(text_of("population.size").starts_with("1"));
    CHECK(text_of("selection.method") == "MAP-Elites");
}

}  // namespace
}  // namespace cambrian
