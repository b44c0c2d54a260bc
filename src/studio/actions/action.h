#pragma once

// All that the user can do in the window, once: the menus, the keys, the help page of keys and the
// command palette read these tables.

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"
#include "studio/host/key_press.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

struct Action {
    std::string id;     // by which menus name it; the same for its counterpart in another mode
    std::string keys;   // "Ctrl+S", "Ctrl+F or /"; empty for none
    std::string label;  // as in a menu; the keys of an action without label are told by another
    std::function<void(const FrameContext& frame, Requests& out)> ask;
    std::function<bool(const FrameContext& frame)> enabled = {};  // null means always
    std::function<bool(const FrameContext& frame)> chosen = {};   // null unless it is on or off
    std::string help = {};                                        // more about it, as a sentence
    bool in_viewer = false;  // its keys work in a window with only a viewport, too
};

struct ActionTable {
    const char* title;
    bool (*active)(const FrameContext& frame);  // null for those that every mode has
    std::vector<Action> actions;
};

// Later tables take precedence while they are active.
const std::vector<ActionTable>& action_tables();

// An action, and whether it can be done now.
struct FoundAction {
    const Action* action = nullptr;  // null if there is none of that name
    bool enabled = false;
};
FoundAction find_action(std::string_view id, const FrameContext& frame);
// Returns the actions of the active tables without those whose id is taken by a later one.
std::vector<FoundAction> present_actions(const FrameContext& frame);
// Returns the keys of an action that are not taken by another one now: "Ctrl+S", or nothing.
std::string present_keys(const Action& action, const FrameContext& frame);

// Returns all keys as a help page in Markdown.
std::string keys_text();

// Does what a key does, if it has an action. While the user types text, only keys with Ctrl count,
// except Ctrl+Z; and Esc closes the open card.
void press_shortcut(const KeyPress& press, bool typing, const FrameContext& frame, Requests& out);

}  // namespace cambrian
