// Evolution, its settings and generations, comparisons and machines.

#include "evolution/fields/setting_words.h"
#include "studio/actions/subjects.h"
#include "studio/experiment/setting_groups.h"
#include "studio/frame/ask_preset.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

template <Place Where>
void focus_place(const FrameContext& frame, Requests& out) {
    if (!frame.view.panels.bottom) toggles<&ViewState::panels, &PanelSizes::bottom>(frame, out);
    out.ask(FocusPlace{Where});
}

// Adds an action for each named set of values.
void add_presets(std::vector<Action>& actions) {
    for (const SettingPreset& preset : setting_presets()) {
        const SettingWords* words = setting_words(preset.table);
        const std::string table(preset.table);
        Action action{
            fmt::format("preset-{}-{}", table, preset.label), "",
            fmt::format("{}: {}", words != nullptr ? std::string(words->word) : group_title(table),
                        preset.label),
            [&preset](const FrameContext& frame, Requests& out) {
                ask_preset(preset, frame, out);
            }};
        action.enabled = [](const FrameContext& frame) { return frame.preserve == nullptr; };
        action.help = preset.help;
        actions.push_back(std::move(action));
    }
}

bool picks_by_hand(const FrameContext& frame) {
    return frame.picking != nullptr;
}
// Behind a world the edits are hidden.
bool undoes(const FrameContext& frame) {
    return !frame.world_shown() && frame.can_undo();
}
bool redoes(const FrameContext& frame) {
    return !frame.world_shown() && frame.can_redo();
}
bool in_plane(const FrameContext& frame) {
    return !frame.in_space();
}
bool has_creatures(const FrameContext& frame) {
    return !frame.experiment.snapshot.population.empty();
}

}  // namespace

std::vector<Action> evolution_actions() {
    // clang-format off
    std::vector<Action> actions = {
        {"evolve", "Space", "Evolve or pause", asks<ToggleEvolution{}>},
        {"evolve-once", "G", "Evolve one generation", asks<RunOneGeneration{}>},
        {"pick-by-hand", "H", "Pick by hand", asks<ToggleHandPicking{}>, {}, picks_by_hand, "Or return to automatic evolution."},
        {"timeline", "T", "Go to the timeline", focus_place<Place::kTimeline>, {}, {}, "Left and Right step through champions, Up and Down change the plot."},
        {"population", "C", "Go to the population", focus_place<Place::kPopulation>, {}, {}, "The arrow keys move through its creatures."},
        {"starred-only", "", "Only starred creatures", toggles<&ViewState::starred_only>, {}, is_on<&ViewState::starred_only>, "In the population, those of all generations."},
        {"one-a-plan", "", "One per body plan", toggles<&ViewState::one_a_plan>, {}, is_on<&ViewState::one_a_plan>, "The population shows the best of each."},
        {"undo", "Ctrl+Z", "Undo", asks<UndoEdit{}>, undoes, {}, "An edit of genes or settings, or a new run."},
        {"redo", "Ctrl+Shift+Z", "Redo", asks<RedoEdit{}>, redoes},
        {"find-setting", "Ctrl+F or /", "Find a setting", asks<FindSetting{}>},
        {"new-run-random", "", "New run", asks<StartNewRun{}>, {}, {}, "From random creatures, with another seed."},
        {"new-run-same-seed", "", "New run with the same seed", asks<StartNewRun{false, true}>},
        {"new-run-space", "", "New run in three dimensions", asks<BeginElsewhere{}>, in_plane, {}, "The run in two is kept."},
        {"new-run-plane", "", "New run in two dimensions", asks<BeginElsewhere{}>, in_space, {}, "The run in three is kept."},
        {"new-run-these", "", "New run from these creatures", asks<StartNewRun{true}>, has_creatures},
        {"compare", "Ctrl+D", "Compare settings…", asks<ToggleComparison{}>},
        {"machines", "Ctrl+M", "Work on several machines…", asks<ToggleMachines{}>},
    };
    // clang-format on
    add_presets(actions);
    return actions;
}

}  // namespace cambrian
