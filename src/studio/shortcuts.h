#pragma once

// Keys and the requests they make: one table for the window, the menus and the help panel.

#include "studio/frame/frame_context.h"
#include "studio/frame/requests.h"
#include "studio/host/key_press.h"

#include <span>
#include <string>

namespace cambrian {

struct Shortcut {
    KeyPress press;
    const char* keys;  // as shown: "Ctrl+S"
    const char* what;  // "Save the creature on display"
    void (*ask)(const FrameContext& frame, Requests& out);
    bool in_viewer = false;  // works where there is only a viewport, too
};

std::span<const Shortcut> shortcuts();
// While the grid of selection by hand is shown; these go before the others.
std::span<const Shortcut> picking_shortcuts();
// Both tables as a page of the help, in Markdown.
std::string keys_text();

// Makes the request of a key, if it has one. While text is typed, only keys with Ctrl count.
void press_shortcut(const KeyPress& press, bool typing, const FrameContext& frame, Requests& out);

}  // namespace cambrian
