#include "studio/shortcuts.h"

#include "studio/preserve/notables.h"
#include "studio/preserve/world_words.h"

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace cambrian {
namespace {

template <class Action>
void simply(const FrameContext&, Requests& out) {
    out.ask(Action{});
}

void toggle_follow(const FrameContext& frame, Requests& out) {
    ViewState view = frame.view;
    view.follow = !view.follow;
    out.ask(ChangeView{view});
}

void switch_theme(const FrameContext& frame, Requests& out) {
    ViewState view = frame.view;
    view.theme = view.theme == ThemeKind::kLight ? ThemeKind::kDark : ThemeKind::kLight;
    out.ask(ChangeView{view});
}

void switch_look(const FrameContext& frame, Requests& out) {
    ViewState view = frame.view;
    view.look = next_look(view.look);
    out.ask(ChangeView{view});
}

void faster(const FrameContext& frame, Requests& out) {
    ViewState view = frame.view;
    for (const double speed : kPlaybackSpeeds) {
        if (speed > view.speed) {
            view.speed = speed;
            break;
        }
    }
    out.ask(ChangeView{view});
}

void slower(const FrameContext& frame, Requests& out) {
    ViewState view = frame.view;
    for (const double speed : kPlaybackSpeeds) {
        if (speed < frame.view.speed) view.speed = speed;
    }
    out.ask(ChangeView{view});
}

void open_file(const FrameContext&, Requests& out) {
    out.ask(OpenFilePanel{FileTask::kOpen});
}

void save_creature(const FrameContext&, Requests& out) {
    out.ask(OpenFilePanel{FileTask::kSaveCreature});
}

void save_experiment(const FrameContext&, Requests& out) {
    out.ask(OpenFilePanel{FileTask::kSaveExperiment});
}
void save_settings(const FrameContext&, Requests& out) {
    out.ask(OpenFilePanel{FileTask::kSaveSettings});
}

void export_statistics(const FrameContext&, Requests& out) {
    out.ask(OpenFilePanel{FileTask::kSaveStatistics});
}

void export_plot(const FrameContext&, Requests& out) {
    out.ask(OpenFilePanel{FileTask::kSavePlot});
}

template <Place Where>
void focus_place(const FrameContext& frame, Requests& out) {
    if (!frame.view.panels.bottom) {
        ViewState view = frame.view;
        view.panels.bottom = true;
        out.ask(ChangeView{view});
    }
    out.ask(FocusPlace{Where});
}

// Closes the topmost card; returns false if none is open.
bool close_card(const FrameContext& frame, Requests& out) {
    if (frame.tour_shown()) {
        out.ask(TurnTour{-1});
    } else if (frame.samples_shown()) {
        out.ask(ToggleSamples{});
    } else if (frame.preserve_card.open) {
        out.ask(TogglePreserveCard{});
    } else if (frame.files.browser.open) {
        out.ask(CloseFilePanel{});
    } else if (frame.machines != nullptr && frame.machines->card_open) {
        out.ask(ToggleMachines{});
    } else if (frame.comparison != nullptr && frame.comparison->card_open) {
        out.ask(ToggleComparison{});
    } else if (frame.guide.help_shown) {
        out.ask(ToggleHelp{});
    } else {
        return false;
    }
    return true;
}

void close_what_is_open(const FrameContext& frame, Requests& out) {
    if (close_card(frame, out)) return;
    if (frame.preserve != nullptr && frame.window.notice == nullptr) {
        if (frame.preserve->single) return out.ask(ShowWorld{});
        if (frame.preserve->wall.on) return out.ask(ToggleWalls{});
        out.ask(PickResident{0});
    } else if (frame.picking != nullptr && frame.picking->single &&
               frame.window.notice == nullptr) {
        out.ask(ShowGrid{});
    } else {
        out.ask(DismissNotice{});
    }
}

constexpr std::array kShortcuts = {
    Shortcut{{GLFW_KEY_SPACE}, "Space", "Evolve or pause", simply<ToggleEvolution>},
    Shortcut{{GLFW_KEY_G}, "G", "Evolve one generation", simply<RunOneGeneration>},
    Shortcut{
        {GLFW_KEY_P}, "P", "Play or pause the creature on display", simply<TogglePlayback>, true},
    Shortcut{{GLFW_KEY_R}, "R", "Restart the creature on display", simply<RestartPlayback>, true},
    Shortcut{{GLFW_KEY_PERIOD}, ".", "Play one tick", simply<StepPlayback>, true},
    Shortcut{{GLFW_KEY_COMMA}, ",", "Go back one tick", simply<StepPlaybackBack>, true},
    Shortcut{{GLFW_KEY_LEFT_BRACKET}, "[", "Play slower", slower, true},
    Shortcut{{GLFW_KEY_RIGHT_BRACKET}, "]", "Play faster", faster, true},
    Shortcut{
        {GLFW_KEY_F}, "F", "Follow the creature with the camera, or stop", toggle_follow, true},
    Shortcut{{GLFW_KEY_HOME}, "Home", "Fit the creature into view", simply<FitView>, true},
    Shortcut{{GLFW_KEY_H},
             "H",
             "Pick by hand, or return to automatic evolution",
             simply<ToggleHandPicking>},
    Shortcut{{GLFW_KEY_N}, "N", "Show the newest champion", simply<ShowNewest>},
    Shortcut{{GLFW_KEY_T},
             "T",
             "Go to the timeline: Left and Right step through champions, Up and Down change the "
             "plot",
             focus_place<Place::kTimeline>},
    Shortcut{{GLFW_KEY_C},
             "C",
             "Go to the population: the arrow keys move through its creatures",
             focus_place<Place::kPopulation>},
    Shortcut{{GLFW_KEY_K},
             "K",
             "Star the creature on display, or take its star away",
             simply<ToggleStarOfShown>},
    Shortcut{{GLFW_KEY_N, true}, "Ctrl+N", "New preserve", simply<TogglePreserveCard>},
    Shortcut{{GLFW_KEY_W, true}, "Ctrl+W", "Close the preserve", simply<ClosePreserve>},
    Shortcut{{GLFW_KEY_O, true},
             "Ctrl+O",
             "Open a creature, an experiment, a preserve or settings",
             open_file},
    Shortcut{{GLFW_KEY_O, true, true}, "Ctrl+Shift+O", "Samples", simply<ToggleSamples>},
    Shortcut{{GLFW_KEY_S, true}, "Ctrl+S", "Save the creature on display", save_creature},
    Shortcut{{GLFW_KEY_K, true}, "Ctrl+K", "Save the experiment", save_experiment},
    Shortcut{{GLFW_KEY_S, true, true}, "Ctrl+Shift+S", "Save the settings", save_settings},
    Shortcut{{GLFW_KEY_E, true}, "Ctrl+E", "Export the statistics as a table", export_statistics},
    Shortcut{{GLFW_KEY_E, true, true}, "Ctrl+Shift+E", "Export the plot as a picture", export_plot},
    Shortcut{{GLFW_KEY_Z, true}, "Ctrl+Z", "Undo an edit of genes or settings", simply<UndoEdit>},
    Shortcut{{GLFW_KEY_Z, true, true}, "Ctrl+Shift+Z", "Redo the edit", simply<RedoEdit>},
    Shortcut{{GLFW_KEY_SLASH}, "/", "Find a setting", simply<FindSetting>},
    Shortcut{{GLFW_KEY_F, true}, "Ctrl+F", "Find a setting", simply<FindSetting>},
    Shortcut{{GLFW_KEY_L, true},
             "Ctrl+L",
             "Switch between the light and the dark theme",
             switch_theme,
             true},
    Shortcut{{GLFW_KEY_L},
             "L",
             "See creatures alive, through their skin, or as boxes",
             switch_look,
             true},
    Shortcut{{GLFW_KEY_D, true}, "Ctrl+D", "Compare settings", simply<ToggleComparison>},
    Shortcut{{GLFW_KEY_M, true},
             "Ctrl+M",
             "Open or close the card of several machines",
             simply<ToggleMachines>},
    Shortcut{{GLFW_KEY_F12}, "F12", "Save a picture of the window", simply<SaveScreenshot>, true},
    Shortcut{{GLFW_KEY_F1}, "F1", "Help", simply<ToggleHelp>},
    Shortcut{{GLFW_KEY_ESCAPE}, "Esc", "Close the open menu or card", close_what_is_open, true},
    Shortcut{{GLFW_KEY_Q, true}, "Ctrl+Q", "Quit", simply<QuitStudio>, true},
};

template <class Asked>
void ask_picking(const FrameContext&, Requests& out) {
    out.ask(AskPicking{Asked{}});
}

// Returns the number of cells of the displayed grid; 0 before there is one.
std::size_t cells(const FrameContext& frame) {
    const PickingTree& tree = frame.picking->snapshot.tree;
    return tree.empty() ? 0 : tree.current().creatures.size();
}

void pick(std::size_t cell, const FrameContext& frame, Requests& out) {
    if (cell >= cells(frame)) return;
    out.ask(FocusCell{cell});
    out.ask(AskPicking{TogglePick{frame.picking->snapshot.tree.current().number, cell}});
}

void pick_first(const FrameContext& frame, Requests& out) {
    pick(0, frame, out);
}

void pick_focused(const FrameContext& frame, Requests& out) {
    pick(frame.picking->focus, frame, out);
}

// Moves the focus so many cells to the right and down, if there is such a cell.
template <int right, int down>
void move_focus(const FrameContext& frame, Requests& out) {
    const auto count = static_cast<int>(cells(frame));
    const int columns = grid_columns(count);
    const auto focus = static_cast<int>(frame.picking->focus);
    const int column = focus % columns + right;
    const int next = focus + right + columns * down;
    if (column < 0 || column >= columns || next < 0 || next >= count) return;
    out.ask(FocusCell{static_cast<std::size_t>(next)});
}

void show_focused(const FrameContext& frame, Requests& out) {
    out.ask(ShowCell{frame.picking->focus});
}

void save_focused(const FrameContext& frame, Requests& out) {
    out.ask(SaveCell{frame.picking->focus});
}

void pin_focused(const FrameContext& frame, Requests& out) {
    if (cells(frame) == 0) return;
    out.ask(AskPicking{
        PinCreature{frame.picking->snapshot.tree.current().number, frame.picking->focus}});
}

void ask_evolution(const FrameContext& frame, Requests& out) {
    out.ask(AskPicking{AskEvolution{frame.picking->options.assisted_generations}});
}

// The keys of the first twelve cells. The table below names them in one line.
constexpr std::array kCellKeys = {GLFW_KEY_1, GLFW_KEY_2, GLFW_KEY_3,     GLFW_KEY_4,
                                  GLFW_KEY_5, GLFW_KEY_6, GLFW_KEY_7,     GLFW_KEY_8,
                                  GLFW_KEY_9, GLFW_KEY_0, GLFW_KEY_MINUS, GLFW_KEY_EQUAL};

constexpr std::array kPickingShortcuts = {
    Shortcut{{kCellKeys.front()},
             "1 to 9, 0, -, =",
             "Pick or unpick one of the first twelve creatures",
             pick_first},
    Shortcut{{GLFW_KEY_SPACE}, "Space", "Pick or unpick the creature in focus", pick_focused},
    Shortcut{{GLFW_KEY_LEFT}, "←", "Move the focus to the left", move_focus<-1, 0>},
    Shortcut{{GLFW_KEY_RIGHT}, "→", "Move the focus to the right", move_focus<1, 0>},
    Shortcut{{GLFW_KEY_UP}, "↑", "Move the focus up", move_focus<0, -1>},
    Shortcut{{GLFW_KEY_DOWN}, "↓", "Move the focus down", move_focus<0, 1>},
    Shortcut{
        {GLFW_KEY_ENTER}, "Enter", "Breed the next grid from the picks", ask_picking<BreedPicks>},
    Shortcut{{GLFW_KEY_BACKSPACE}, "Backspace", "Go back one grid", ask_picking<GoBack>},
    Shortcut{{GLFW_KEY_BACKSPACE, false, true},
             "Shift+Backspace",
             "Go forward again",
             ask_picking<GoForward>},
    Shortcut{{GLFW_KEY_R},
             "R",
             "Random creatures in place of those not picked",
             ask_picking<ReplaceUnpicked>},
    Shortcut{{GLFW_KEY_G}, "G", "Evolve for some generations from the picks", ask_evolution},
    Shortcut{{GLFW_KEY_DELETE}, "Delete", "Unpick all creatures", ask_picking<ClearPicks>},
    Shortcut{{GLFW_KEY_V}, "V", "View the creature in focus alone", show_focused},
    Shortcut{{GLFW_KEY_S}, "S", "Save the creature in focus", save_focused},
    Shortcut{{GLFW_KEY_S, true}, "Ctrl+S", "Save the creature in focus", save_focused},
    Shortcut{{GLFW_KEY_K}, "K", "Keep the creature in focus on the shelf", pin_focused},
};

void step_world(const FrameContext&, Requests& out) {
    out.ask(AskPreserve{StepPreserve{}});
}

// Goes to a faster or slower pace of the world.
template <int Steps>
void change_pace(const FrameContext& frame, Requests& out) {
    const auto found =
        std::find(kPreservePaces.begin(), kPreservePaces.end(), frame.preserve->picture.pace);
    const int last = static_cast<int>(kPreservePaces.size()) - 1;
    const int next = std::clamp(static_cast<int>(found - kPreservePaces.begin()) + Steps, 0, last);
    out.ask(AskPreserve{PacePreserve{kPreservePaces[static_cast<std::size_t>(next)]}});
}

template <int Steps>
void pick_next(const FrameContext&, Requests& out) {
    out.ask(PickNext{Steps});
}

void keep_preserve(const FrameContext& frame, Requests& out) {
    if (!frame.preserve->file.empty()) out.ask(OpenFilePanel{FileTask::kSavePreserve});
}

// Goes to the last snapshot before the present tick, so that repeated presses go through all.
void go_back(const FrameContext& frame, Requests& out) {
    const auto& ticks = *frame.preserve->picture.snapshots;
    if (ticks.empty()) return;
    const auto later = std::lower_bound(ticks.begin(), ticks.end(), frame.preserve->picture.tick);
    out.ask(BranchFrom{later == ticks.begin() ? *later : *(later - 1)});
}

// Returns the creature so many places after the picked one, or the first or the last one.
std::uint64_t next_of(const std::vector<std::uint64_t>& creatures, std::uint64_t picked,
                      int steps) {
    const auto count = static_cast<int>(creatures.size());
    const auto found = std::find(creatures.begin(), creatures.end(), picked);
    int next = steps > 0 ? 0 : count - 1;
    if (found != creatures.end())
        next = (static_cast<int>(found - creatures.begin()) + steps + count) % count;
    return creatures[static_cast<std::size_t>(next)];
}

// Picks the eldest of the next lineage in the order of their sizes.
template <int Steps>
void pick_lineage(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    std::vector<std::uint64_t> eldest;
    std::uint64_t here = 0;
    for (const LineageCount& lineage : lineages_in(preserve.picture)) {
        eldest.push_back(lineage.eldest);
        if (preserve.picked != nullptr && preserve.picked->life.lineage == lineage.number)
            here = lineage.eldest;
    }
    if (!eldest.empty()) out.ask(PickResident{next_of(eldest, here, Steps)});
}

void pick_notable(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    std::vector<std::uint64_t> notables;
    for (const Notable& each : notables_in(preserve.picture)) {
        if (std::find(notables.begin(), notables.end(), each.creature) == notables.end())
            notables.push_back(each.creature);
    }
    if (notables.empty()) return;
    const std::uint64_t here = preserve.picked == nullptr ? 0 : preserve.picked->life.number;
    out.ask(PickResident{next_of(notables, here, 1)});
}

// Picks the parent that comes first in this order, if it is alive, or else the other one.
template <int First>
void pick_parent(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    if (preserve.picked == nullptr) return;
    const auto& parents = preserve.picked->life.parents;
    for (const std::uint64_t parent : {parents[First], parents[1 - First]}) {
        if (preserve.picture.find(parent) != nullptr) return out.ask(PickResident{parent});
    }
}

void pick_child(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    if (preserve.picked == nullptr) return;
    const std::uint64_t number = preserve.picked->life.number;
    for (const ResidentPicture& each : preserve.picture.residents) {
        const auto& parents = each.life.parents;
        if (std::find(parents.begin(), parents.end(), number) != parents.end())
            return out.ask(PickResident{each.life.number});
    }
}

// Picks the next of those with the same first parent.
void pick_sibling(const FrameContext& frame, Requests& out) {
    const PreserveView& preserve = *frame.preserve;
    if (preserve.picked == nullptr || preserve.picked->life.parents[0] == 0) return;
    std::vector<std::uint64_t> siblings;
    for (const ResidentPicture& each : preserve.picture.residents) {
        if (each.life.parents[0] == preserve.picked->life.parents[0])
            siblings.push_back(each.life.number);
    }
    if (!siblings.empty())
        out.ask(PickResident{next_of(siblings, preserve.picked->life.number, 1)});
}

template <int Steps>
void turn_plot(const FrameContext&, Requests& out) {
    out.ask(TurnPlot{Steps});
}

void open_left_panels(const FrameContext& frame, Requests& out) {
    if (frame.view.panels.left) return;
    ViewState view = frame.view;
    view.panels.left = true;
    out.ask(ChangeView{view});
}

void show_next_list(const FrameContext& frame, Requests& out) {
    open_left_panels(frame, out);
    const auto next = (static_cast<std::size_t>(frame.preserve->list) + 1) % kWorldListNames.size();
    out.ask(ShowList{static_cast<WorldList>(next)});
}

// Shows the museum or, if it is shown already, goes so many creatures further in it.
template <int Steps>
void turn_museum(const FrameContext& frame, Requests& out) {
    open_left_panels(frame, out);
    const PreserveView& preserve = *frame.preserve;
    const auto count = static_cast<int>(preserve.picture.museum->size());
    if (count == 0 || preserve.list != WorldList::kMuseum)
        return out.ask(ShowList{WorldList::kMuseum});
    const int next = (static_cast<int>(preserve.piece) + Steps + count) % count;
    out.ask(ChoosePiece{static_cast<std::size_t>(next)});
}

void type_laws(const FrameContext& frame, Requests& out) {
    open_left_panels(frame, out);
    out.ask(TypeLaws{});
}

constexpr std::array kPreserveShortcuts = {
    Shortcut{{GLFW_KEY_SPACE}, "Space", "Play or pause the world", simply<TogglePlay>},
    Shortcut{{GLFW_KEY_PERIOD}, ".", "One tick of the world, then pause", step_world},
    Shortcut{{GLFW_KEY_LEFT_BRACKET}, "[", "Slower", change_pace<-1>},
    Shortcut{{GLFW_KEY_RIGHT_BRACKET}, "]", "Faster, up to as fast as it goes", change_pace<1>},
    Shortcut{{GLFW_KEY_TAB}, "Tab", "Pick the next creature", pick_next<1>},
    Shortcut{{GLFW_KEY_TAB, false, true}, "Shift+Tab", "Pick the one before", pick_next<-1>},
    Shortcut{{GLFW_KEY_L}, "L", "Pick the eldest of the next lineage", pick_lineage<1>},
    Shortcut{{GLFW_KEY_L, false, true},
             "Shift+L",
             "Pick the eldest of the lineage before",
             pick_lineage<-1>},
    Shortcut{{GLFW_KEY_O}, "O", "Pick the next outstanding creature", pick_notable},
    Shortcut{{GLFW_KEY_U}, "U", "Pick the picked creature's parent", pick_parent<0>},
    Shortcut{{GLFW_KEY_U, false, true}, "Shift+U", "Pick its other parent", pick_parent<1>},
    Shortcut{{GLFW_KEY_C}, "C", "Pick its eldest living child", pick_child},
    Shortcut{{GLFW_KEY_C, false, true},
             "Shift+C",
             "Pick the next child of its first parent",
             pick_sibling},
    Shortcut{{GLFW_KEY_T}, "T", "Show the next plot of the history", turn_plot<1>},
    Shortcut{{GLFW_KEY_T, false, true}, "Shift+T", "Show the plot before", turn_plot<-1>},
    Shortcut{{GLFW_KEY_N},
             "N",
             "Show the next list on the left: lineages, laws, museum",
             show_next_list},
    Shortcut{{GLFW_KEY_J},
             "J",
             "Type the value of the first law; Tab goes on to the next, Enter takes it",
             type_laws},
    Shortcut{{GLFW_KEY_G}, "G", "Show the museum; choose its next creature", turn_museum<1>},
    Shortcut{{GLFW_KEY_G, false, true},
             "Shift+G",
             "Show the museum; choose the creature before",
             turn_museum<-1>},
    Shortcut{{GLFW_KEY_ENTER},
             "Enter",
             "View the chosen creature of the museum alone",
             simply<ShowPiece>},
    Shortcut{{GLFW_KEY_S, false, true},
             "Shift+S",
             "Save the chosen creature of the museum",
             simply<SavePiece>},
    Shortcut{{GLFW_KEY_F}, "F", "Follow the picked creature with the camera", simply<FollowPicked>},
    Shortcut{{GLFW_KEY_P}, "P", "Pin the picked creature, or unpin it", simply<PinPicked>},
    Shortcut{{GLFW_KEY_P, false, true},
             "Shift+P",
             "Pin descendants of pinned creatures, too, or no longer",
             simply<InheritPins>},
    Shortcut{{GLFW_KEY_S}, "S", "Save the picked creature", simply<SaveResident>},
    Shortcut{{GLFW_KEY_S, true}, "Ctrl+S", "Save the picked creature", simply<SaveResident>},
    Shortcut{{GLFW_KEY_V}, "V", "View the picked creature alone", simply<ShowPicked>},
    Shortcut{{GLFW_KEY_DELETE},
             "Delete",
             "Remove the picked creature; its energy becomes flesh",
             simply<RemovePicked>},
    Shortcut{{GLFW_KEY_M},
             "M",
             "Move the picked creature to the mouse, or to the middle of the view",
             simply<MovePickedThere>},
    Shortcut{{GLFW_KEY_E}, "E", "Feed ten plants there", simply<FeedThere>},
    Shortcut{{GLFW_KEY_A}, "A", "Add a copy of the creature on display there", simply<AddShown>},
    Shortcut{{GLFW_KEY_W}, "W", "Begin a wall there, or end it there", simply<DrawWall>},
    Shortcut{{GLFW_KEY_X}, "X", "Erase the wall there", simply<EraseWallThere>},
    Shortcut{{GLFW_KEY_R},
             "R",
             "Show the store of each creature as a ring, or no longer",
             simply<ToggleEnergyRings>},
    Shortcut{{GLFW_KEY_HOME}, "Home", "Fit the world into view", simply<FitWorld>},
    Shortcut{{GLFW_KEY_Z, true},
             "Ctrl+Z",
             "Go back to the snapshot before, in a file of its own",
             go_back},
    Shortcut{{GLFW_KEY_K, true}, "Ctrl+K", "Keep the preserve in another file", keep_preserve},
};

// The shortcuts of the viewer, besides those of the studio that make sense there.
constexpr std::array kViewerShortcuts = {
    Shortcut{{GLFW_KEY_SPACE}, "Space", "Play or pause the creature", simply<TogglePlayback>, true},
};

// Makes the request of a key and returns true if the table has the key.
bool press_in(std::span<const Shortcut> table, const KeyPress& press, const FrameContext& frame,
              Requests& out) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const Shortcut& each) {
        return each.press == press && (!frame.window.viewer_only || each.in_viewer);
    });
    if (found == table.end()) return false;
    found->ask(frame, out);
    return true;
}

bool press_in_grid(const KeyPress& press, const FrameContext& frame, Requests& out) {
    if (press_in(kPickingShortcuts, press, frame, out)) return true;
    const auto key = std::find(kCellKeys.begin(), kCellKeys.end(), press.key);
    if (key == kCellKeys.end() || press.control || press.shift) return false;
    pick(static_cast<std::size_t>(key - kCellKeys.begin()), frame, out);
    return true;
}

std::string table_of(std::span<const Shortcut> keys) {
    std::string text = "| key | what it does |\n|---|---|\n";
    for (const Shortcut& shortcut : keys)
        text += fmt::format("| `{}` | {} |\n", shortcut.keys, shortcut.what);
    return text;
}

}  // namespace

std::span<const Shortcut> shortcuts() {
    return kShortcuts;
}

std::span<const Shortcut> picking_shortcuts() {
    return kPickingShortcuts;
}

std::span<const Shortcut> preserve_shortcuts() {
    return kPreserveShortcuts;
}

std::string keys_text() {
    return fmt::format(
        "# Keys\n\n{}\n## While picking by hand\n\n{}\n## In a preserve\n\n{}| arrow keys | Move "
        "the view "
        "|\n| `Page Up`, `Page Down` | Come closer, or go farther away |\n\nIn the filter of the "
        "settings, `Enter` goes "
        "to the value of the first setting found and `Esc` clears it. Among the samples, arrows "
        "choose and `Enter` opens. `Tab` and `Shift+Tab` go from control to control, and `Enter` "
        "presses the one with the ring.\n",
        table_of(shortcuts()), table_of(picking_shortcuts()), table_of(preserve_shortcuts()));
}

void press_shortcut(const KeyPress& press, bool typing, const FrameContext& frame, Requests& out) {
    if (typing && press.key == GLFW_KEY_ESCAPE) {
        static_cast<void>(close_card(frame, out));
        return;
    }
    if (typing && (!press.control || press.key == GLFW_KEY_Z)) return;
    if (frame.world_shown()) {
        if (!frame.covered() && press_in(kPreserveShortcuts, press, frame, out)) return;
    } else if (frame.grid_shown() && !frame.covered() && press_in_grid(press, frame, out)) {
        return;
    }
    if (frame.window.viewer_only && press_in(kViewerShortcuts, press, frame, out)) return;
    static_cast<void>(press_in(kShortcuts, press, frame, out));
}

}  // namespace cambrian
