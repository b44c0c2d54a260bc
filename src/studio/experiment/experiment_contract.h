#pragma once

// What panels see of the open experiment and what they may request of it.

#include "evolution/engine/command.h"
#include "evolution/engine/snapshot.h"
#include "evolution/fields/setting_field.h"
#include "studio/experiment/progress_view.h"
#include "studio/experiment/settings_editor.h"

#include <string>
#include <variant>
#include <vector>

namespace cambrian {

struct ToggleEvolution {};
struct RunOneGeneration {};
// Replaces the draft after an edit of one field ("environment.gravity").
struct EditSettings {
    ExperimentSettings settings;
    std::string field;
};
// The control was released: the engine gets the draft.
struct FinishEdit {};
// Undoes the last edit of the genes on display or, if none was edited, of the settings.
struct UndoEdit {};
struct RedoEdit {};
// Begins a new generation 0 with the draft, from random creatures or the present population.
struct StartNewRun {
    bool keep_population = false;
};
// The same from the creature on display and what the settings fill up with.
struct StartFromShown {};
// Takes every setting that cannot change while running from what is running.
struct DropStructuralEdits {};
// Gives the keyboard to the filter of the settings.
struct FindSetting {};

using ExperimentRequest =
    std::variant<ToggleEvolution, RunOneGeneration, EditSettings, FinishEdit, UndoEdit, RedoEdit,
                 StartNewRun, StartFromShown, DropStructuralEdits, AddNewcomers, FindSetting>;

struct ExperimentView {
    const std::vector<SettingField>& fields;
    const EvolutionSnapshot& snapshot;
    const ProgressView& progress;
    const SettingsEditor& editor;
    unsigned find_asked = 0;    // how often a setting was to be found
    bool previous_run = false;  // whether there is one that could be opened
};

}  // namespace cambrian
