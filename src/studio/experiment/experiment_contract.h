#pragma once

// The data of the open experiment that panels see, and the requests they may make of it.

#include "evolution/engine/command.h"
#include "evolution/engine/snapshot.h"
#include "evolution/fields/setting_field.h"
#include "studio/experiment/progress_view.h"
#include "studio/experiment/settings_editor.h"
#include "world/terrain.h"

#include <string>
#include <variant>
#include <vector>

namespace cambrian {

struct ToggleEvolution {};
struct RunOneGeneration {};
// Replaces the draft settings after an edit of the named field, for example "environment.gravity".
struct EditSettings {
    ExperimentSettings settings;
    std::string field;
};
// Ends an edit when the control is released; the engine then gets the draft.
struct FinishEdit {};
// Replaces the profile of the draft's ground between the ends of a stroke (world/ground_stroke.h).
struct DrawGround {
    std::vector<GroundPoint> stroke;
};
// Goes back to the run before if a new run was the last thing done; otherwise undoes the last edit
// of the displayed creature's genes or, if there is none, of the settings.
struct UndoEdit {};
struct RedoEdit {};
// Starts a new run from generation 0 with the draft settings. The founders are the present
// population or random creatures. With the same seed and random creatures it repeats the present
// run as far as the settings are equal; otherwise a new seed is drawn.
struct StartNewRun {
    bool keep_population = false;
    bool same_seed = false;
};
// Starts a new run whose founders are the displayed creature and those that the settings add.
struct StartFromShown {};
// Starts a new run as StartFromShown does, and evolves. In its world, the goal, the world and the
// trial become those that judge the displayed creature.
struct EvolveShown {
    bool in_its_world = false;
};
// Displays a creature of one part, in the world of the experiment, and takes up the pen to draw it.
struct DrawNewCreature {};
// Resets every draft setting that cannot change during a run to its value in the present run.
struct DropStructuralEdits {};
// Moves the keyboard focus to the filter of the settings.
struct FindSetting {};
// Shows a setting in its panel, for example "environment.gravity", and lights it up.
struct ShowSetting {
    std::string path;
};

using ExperimentRequest =
    std::variant<ToggleEvolution, RunOneGeneration, EditSettings, FinishEdit, DrawGround, UndoEdit,
                 RedoEdit, StartNewRun, StartFromShown, EvolveShown, DrawNewCreature,
                 DropStructuralEdits, AddImmigrants, FindSetting, ShowSetting>;

struct ExperimentView {
    const std::vector<SettingField>& fields;
    const EvolutionSnapshot& snapshot;
    const ProgressView& progress;
    const SettingsEditor& editor;
    unsigned find_asked = 0;    // number of FindSetting requests so far
    unsigned show_asked = 0;    // of ShowSetting requests
    std::string shown = {};     // the setting of the last of them
    bool previous_run = false;  // whether an earlier run can be opened
    bool new_run = false;       // whether a new run was the last thing done, and can be undone
};

}  // namespace cambrian
