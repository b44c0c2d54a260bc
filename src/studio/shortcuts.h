#pragma once

// Keyboard shortcuts and their requests: one table for the window, the menus and the help page.

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"
#include "studio/host/key_press.h"

#include <span>
#include <string>

namespace cambrian {

struct Shortcut {
    KeyPress press;
    const char* keys;  // text displayed for the keys: "Ctrl+S"
    const char* what;  // "Save the creature on display"
    void (*ask)(const FrameContext& frame, Requests& out);
    bool in_viewer = false;  // works in a window with only a viewport, too
};

std::span<const Shortcut> shortcuts();
// The shortcuts while a picking grid is displayed. They take precedence over the others.
std::span<const Shortcut> picking_shortcuts();
// The shortcuts while a preserve is displayed. They take precedence over the others, too.
std::span<const Shortcut> preserve_shortcuts();
// Returns all tables as a help page in Markdown.
std::string keys_text();

// Makes the request of a key, if it has one. While the user types text, only keys with Ctrl count,
// except Ctrl+Z; and Esc closes the open card.
void press_shortcut(const KeyPress& press, bool typing, const FrameContext& frame, Requests& out);

}  // namespace cambrian
