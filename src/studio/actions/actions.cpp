#include "studio/actions/action.h"
#include "studio/actions/subjects.h"

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

bool over_grid(const FrameContext& frame) {
    return frame.grid_shown() && !frame.world_shown();
}
bool over_world(const FrameContext& frame) {
    return frame.world_shown();
}
bool on_paper(const FrameContext& frame) {
    return frame.drawing();
}
bool viewer_only(const FrameContext& frame) {
    return frame.window.viewer_only;
}

bool is_active(const ActionTable& table, const FrameContext& frame) {
    return table.active == nullptr || table.active(frame);
}

struct NamedKey {
    std::string_view name;
    int key;
};
constexpr std::array kNamedKeys = {
    NamedKey{"Space", GLFW_KEY_SPACE},   NamedKey{"Home", GLFW_KEY_HOME},
    NamedKey{"Enter", GLFW_KEY_ENTER},   NamedKey{"Backspace", GLFW_KEY_BACKSPACE},
    NamedKey{"Delete", GLFW_KEY_DELETE}, NamedKey{"Tab", GLFW_KEY_TAB},
    NamedKey{"Esc", GLFW_KEY_ESCAPE},    NamedKey{"F1", GLFW_KEY_F1},
    NamedKey{"F11", GLFW_KEY_F11},       NamedKey{"F12", GLFW_KEY_F12},
    NamedKey{"←", GLFW_KEY_LEFT},        NamedKey{"→", GLFW_KEY_RIGHT},
    NamedKey{"↑", GLFW_KEY_UP},          NamedKey{"↓", GLFW_KEY_DOWN},
    NamedKey{"Plus", GLFW_KEY_EQUAL},    NamedKey{"Minus", GLFW_KEY_MINUS},
    NamedKey{"Keypad 1", GLFW_KEY_KP_1}, NamedKey{"Keypad 3", GLFW_KEY_KP_3},
    NamedKey{"Keypad 5", GLFW_KEY_KP_5}, NamedKey{"Keypad 7", GLFW_KEY_KP_7},
};

bool take_prefix(std::string_view& text, std::string_view prefix) {
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
}

KeyPress press_of(std::string_view keys) {
    KeyPress press;
    press.control = take_prefix(keys, "Ctrl+");
    press.shift = take_prefix(keys, "Shift+");
    const auto named = std::find_if(kNamedKeys.begin(), kNamedKeys.end(),
                                    [keys](const NamedKey& each) { return each.name == keys; });
    // A letter, a digit or a sign is its own key.
    press.key = named == kNamedKeys.end() ? static_cast<unsigned char>(keys.front()) : named->key;
    return press;
}

// Returns the press that keys name: plus, minus and zero are on several.
KeyPress usual_press(KeyPress press) {
    constexpr std::array same = {std::pair{GLFW_KEY_KP_ADD, GLFW_KEY_EQUAL},
                                 std::pair{GLFW_KEY_KP_SUBTRACT, GLFW_KEY_MINUS},
                                 std::pair{GLFW_KEY_KP_0, GLFW_KEY_0}};
    for (const auto& [other, usual] : same)
        if (press.key == other) press.key = usual;
    if (press.control && press.key == GLFW_KEY_EQUAL) press.shift = false;
    return press;
}

// Returns the presses that "Ctrl+F or /" names.
std::vector<KeyPress> presses_of(std::string_view keys) {
    constexpr std::string_view between = " or ";
    std::vector<KeyPress> presses;
    while (!keys.empty()) {
        const std::size_t end = std::min(keys.find(between), keys.size());
        presses.push_back(press_of(keys.substr(0, end)));
        keys.remove_prefix(std::min(end + between.size(), keys.size()));
    }
    return presses;
}

bool has_press(const Action& action, const KeyPress& press) {
    const std::vector<KeyPress> presses = presses_of(action.keys);
    return std::find(presses.begin(), presses.end(), press) != presses.end();
}

// Returns what a key does now. Over the grid and the world, a card gets the keys of the mode.
const Action* action_of(const KeyPress& press, const FrameContext& frame) {
    const auto& tables = action_tables();
    for (auto table = tables.rbegin(); table != tables.rend(); ++table) {
        const bool is_mode = table->active != nullptr && !frame.window.viewer_only;
        if (!is_active(*table, frame) || (is_mode && frame.covered())) continue;
        for (const Action& action : table->actions) {
            if (frame.window.viewer_only && !action.in_viewer) continue;
            if (has_press(action, press)) return &action;
        }
    }
    return nullptr;
}

bool can_be_done(const Action& action, const FrameContext& frame) {
    return !action.enabled || action.enabled(frame);
}

std::string told(const Action& action) {
    if (action.help.empty()) return action.label;
    return action.label + (action.label.ends_with("…") ? " " : ". ") + action.help;
}

std::string code(std::string keys) {
    const std::size_t between = keys.find(" or ");
    if (between != std::string::npos) keys.replace(between, 4, "` or `");
    return "`" + keys + "`";
}

}  // namespace

const std::vector<ActionTable>& action_tables() {
    static const std::vector<ActionTable> tables = {
        {"Evolution", nullptr, evolution_actions()},
        {"The creature on display", nullptr, creature_actions()},
        {"Files", nullptr, file_actions()},
        {"The window", nullptr, view_actions()},
        {"Help", nullptr, help_actions()},
        {"While picking by hand", over_grid, picking_actions()},
        {"In a preserve", over_world, preserve_actions()},
        {"While drawing a creature", on_paper, drawing_actions()},
        {"In a window for one creature",
         viewer_only,
         {{"play",
           "Space",
           "Play or pause the creature",
           asks<TogglePlayback{}>,
           {},
           {},
           "",
           true}}},
    };
    return tables;
}

FoundAction find_action(std::string_view id, const FrameContext& frame) {
    FoundAction found;
    for (const ActionTable& table : action_tables()) {
        const bool active = is_active(table, frame);
        for (const Action& action : table.actions) {
            if (action.id == id && (active || found.action == nullptr))
                found = {&action, active && can_be_done(action, frame)};
        }
    }
    return found;
}

std::vector<FoundAction> present_actions(const FrameContext& frame) {
    std::vector<FoundAction> all;
    for (const ActionTable& table : action_tables()) {
        if (!is_active(table, frame)) continue;
        for (const Action& action : table.actions) {
            if (find_action(action.id, frame).action == &action && !action.label.empty())
                all.push_back({&action, can_be_done(action, frame)});
        }
    }
    return all;
}

std::string present_keys(const Action& action, const FrameContext& frame) {
    if (action.keys.empty()) return {};
    const Action* pressed =
        action_of(press_of(action.keys.substr(0, action.keys.find(" or "))), frame);
    return pressed == &action ? action.keys : std::string();
}

std::string keys_text() {
    std::string text = "# Keys\n";
    for (const ActionTable& table : action_tables()) {
        text += fmt::format("\n## {}\n\n| key | what it does |\n|---|---|\n", table.title);
        for (const Action& action : table.actions) {
            if (action.keys.empty() || action.label.empty()) continue;
            text += fmt::format("| {} | {} |\n", code(action.keys), told(action));
        }
        if (table.active == over_world)
            text +=
                "| arrow keys | Move the view |\n| `Page Up`, `Page Down` | Come closer, or go "
                "farther away |\n";
    }
    return text +
           "\nIn the filter of the settings, `Enter` goes to the value of the first setting found "
           "and `Esc` clears it. Among the samples, arrows choose and `Enter` opens. `Tab` and "
           "`Shift+Tab` go from control to control, and `Enter` presses the one with the ring.\n";
}

void press_shortcut(const KeyPress& press, bool typing, const FrameContext& frame, Requests& out) {
    if (frame.window.presenting) return out.ask(TogglePresentation{});
    if (typing && press.key == GLFW_KEY_ESCAPE) {
        static_cast<void>(close_card(frame, out));
        return;
    }
    if (typing && (!press.control || press.key == GLFW_KEY_Z)) return;
    if (const Action* action = action_of(usual_press(press), frame)) action->ask(frame, out);
}

}  // namespace cambrian
