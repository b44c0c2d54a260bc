#include "studio/experiment/goal_choice.h"

#include "evolution/settings/goal_defaults.h"
#include "studio/experiment/settings_editor.h"
#include "support/catch.h"
#include "support/kinds.h"

namespace cambrian {
namespace {

const std::vector<SettingField>& fields() {
    static const std::vector<SettingField> all = setting_fields(test::kinds());
    return all;
}

const GoalKind& goal(std::string_view id) {
    return *test::kinds().goals.find(id);
}

ExperimentSettings defaults_of(std::string_view id) {
    ExperimentSettings settings;
    settings.goal = id;
    adopt_defaults(settings, goal(id));
    return settings;
}

// Returns another value of the field that is in its range.
ExperimentSettings edited(const SettingField& field, ExperimentSettings settings) {
    const SettingRef value = field.at(settings);
    if (auto* const* flag = std::get_if<bool*>(&value)) **flag = !**flag;
    if (auto* const* whole = std::get_if<int*>(&value)) **whole += **whole < field.high ? 1 : -1;
    if (auto* const* number = std::get_if<double*>(&value))
        **number =
            **number == 0.5 * (field.low + field.high) ? field.low : 0.5 * (field.low + field.high);
    return settings;
}

bool belongs_to_world(const SettingField& field) {
    return field.table == "environment" || field.table == "trial" || field.key == "confirmations";
}

// Returns the names of the fields in which two settings differ.
std::vector<std::string> differing_fields(ExperimentSettings& a, ExperimentSettings& b) {
    std::vector<std::string> names;
    for (const SettingField& field : fields()) {
        if (!same_value(field, a, b)) names.push_back(field.table + '.' + field.key);
    }
    return names;
}

TEST_CASE("choosing a goal replaces the default world of the goal before",
          "[studio][goal_choice]") {
    for (const GoalKind& before : test::kinds().goals.all()) {
        for (const GoalKind& chosen : test::kinds().goals.all()) {
            CAPTURE(before.id, chosen.id);
            ExperimentSettings settings = defaults_of(before.id);
            change_goal(settings, before, chosen, fields());
            ExperimentSettings expected = defaults_of(chosen.id);
            CHECK(settings.goal == chosen.id);
            // Senses that are on stay on, and serve a goal that needs some of them.
            if (before.senses.empty() || before.senses == chosen.senses)
                CHECK(differing_fields(settings, expected) == std::vector<std::string>{});
            CHECK(settings.world == expected.world);
            CHECK(may_sense(settings, chosen));
        }
    }
}

TEST_CASE("choosing a goal keeps every edited field and no other", "[studio][goal_choice]") {
    int compared = 0;
    for (const SettingField& field : fields()) {
        ExperimentSettings own = edited(field, defaults_of("walking"));
        ExperimentSettings before = defaults_of("walking");
        if (!belongs_to_world(field) || same_value(field, own, before)) continue;
        CAPTURE(field.table, field.key);
        ExperimentSettings expected = defaults_of("seeking");
        copy_value(field, own, expected);
        change_goal(own, goal("walking"), goal("seeking"), fields());
        CHECK(differing_fields(own, expected) == std::vector<std::string>{});
        ++compared;
    }
    CHECK(compared > 20);
}

TEST_CASE("a sense that a goal needs is on, even if it was switched off for another goal",
          "[studio][goal_choice]") {
    ExperimentSettings settings = defaults_of("seeking");
    for (const std::string& sense : goal("seeking").senses)
        settings.founders.channels[sense] = false;
    ExperimentSettings kept = settings;
    change_goal(kept, goal("seeking"), goal("walking"), fields());
    CHECK_FALSE(may_sense(kept, goal("seeking")));
    change_goal(kept, goal("walking"), goal("seeking"), fields());
    CHECK(may_sense(kept, goal("seeking")));
}

TEST_CASE("undo reverts a choice of goal with all its changes", "[studio][goal_choice]") {
    ExperimentSettings own = defaults_of("walking");
    own.world.trial.duration = 8.0;
    SettingsEditor editor(own);
    ExperimentSettings chosen = own;
    change_goal(chosen, goal("walking"), goal("swimming"), fields());
    editor.edit(chosen, "goal.behavior");
    editor.finish();
    editor.undo();
    CHECK(editor.draft() == own);
}

}  // namespace
}  // namespace cambrian
