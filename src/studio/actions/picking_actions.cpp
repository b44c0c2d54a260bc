// Selection by hand.

#include "studio/actions/subjects.h"

#include <string_view>

namespace cambrian {
namespace {

template <class Asked>
void ask_picking(const FrameContext&, Requests& out) {
    out.ask(AskPicking{Asked{}});
}

// Returns the number of cells of the displayed grid; 0 before there is one.
std::size_t cells(const FrameContext& frame) {
    const PickingTree& tree = frame.picking->snapshot.tree;
    return tree.empty() ? 0 : tree.current().creatures.size();
}
bool has_cells(const FrameContext& frame) {
    return cells(frame) > 0;
}

void pick(std::size_t cell, const FrameContext& frame, Requests& out) {
    if (cell >= cells(frame)) return;
    out.ask(FocusCell{cell});
    out.ask(AskPicking{TogglePick{frame.picking->snapshot.tree.current().number, cell}});
}

void pick_focused(const FrameContext& frame, Requests& out) {
    pick(frame.picking->focus, frame, out);
}

// Moves the focus so many cells to the right and down, if there is such a cell.
template <int Right, int Down>
void move_focus(const FrameContext& frame, Requests& out) {
    const auto count = static_cast<int>(cells(frame));
    const int columns = grid_columns(count);
    const auto focus = static_cast<int>(frame.picking->focus);
    const int column = focus % columns + Right;
    const int next = focus + Right + columns * Down;
    if (column < 0 || column >= columns || next < 0 || next >= count) return;
    out.ask(FocusCell{static_cast<std::size_t>(next)});
}

// Asks for something with the creature in focus.
template <class Request>
void ask_of_focused(const FrameContext& frame, Requests& out) {
    out.ask(Request{frame.picking->focus});
}

void pin_focused(const FrameContext& frame, Requests& out) {
    if (cells(frame) == 0) return;
    out.ask(AskPicking{
        PinCreature{frame.picking->snapshot.tree.current().number, frame.picking->focus}});
}

void ask_evolution(const FrameContext& frame, Requests& out) {
    out.ask(AskPicking{AskEvolution{frame.picking->options.assisted_generations}});
}

}  // namespace

std::vector<Action> picking_actions() {
    // clang-format off
    std::vector<Action> actions = {
        {"pick 1", "1 to 9, 0, -, =", "Pick or unpick one of the first twelve creatures", [](const auto& frame, Requests& out) { pick(0, frame, out); }},
        {"pick", "Space", "Pick or unpick the creature in focus", pick_focused, has_cells},
        {"focus-left", "←", "Move the focus to the left", move_focus<-1, 0>},
        {"focus-right", "→", "Move the focus to the right", move_focus<1, 0>},
        {"focus-up", "↑", "Move the focus up", move_focus<0, -1>},
        {"focus-down", "↓", "Move the focus down", move_focus<0, 1>},
        {"breed", "Enter", "Breed the next grid from the picks", ask_picking<BreedPicks>},
        {"grid-back", "Backspace", "Go back one grid", ask_picking<GoBack>},
        {"grid-forward", "Shift+Backspace", "Go forward again", ask_picking<GoForward>},
        {"replace-unpicked", "R", "Random creatures in place of those not picked", ask_picking<ReplaceUnpicked>},
        {"evolve-picks", "G", "Evolve for some generations from the picks", ask_evolution},
        {"unpick", "Delete", "Unpick all creatures", ask_picking<ClearPicks>},
        {"view-alone", "V", "View the creature in focus alone", ask_of_focused<ShowCell>, has_cells},
        {"save-creature", "Ctrl+S or S", "Save creature…", ask_of_focused<SaveCell>, has_cells, {}, "The one in focus."},
        {"keep", "K", "Keep the creature in focus on the shelf", pin_focused, has_cells},
    };
    // clang-format on
    constexpr std::string_view others = "234567890-=";
    for (std::size_t i = 0; i < others.size(); ++i) {
        actions.push_back(
            {"pick " + std::to_string(i + 2), std::string(1, others[i]), "",
             [i](const FrameContext& frame, Requests& out) { pick(i + 1, frame, out); }});
    }
    return actions;
}

}  // namespace cambrian
