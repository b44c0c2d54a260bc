#pragma once

// Tab and Shift+Tab, and arrows in a menu or a list of choices, go from control to control; the one
// that the keyboard has reached has a ring, and Enter presses it. A text field gets the keys typed.

#include "studio/look/ui_context.h"

namespace cambrian {

// Whether a menu or a list of choices is open.
bool popup_open();
// Must be called once a frame, before anything is drawn; `steps` is how many controls further the
// keyboard goes.
void begin_focus_frame(int steps);
// Leaves out the controls drawn before and, from now on, those outside the window being drawn: a
// card or a menu lies over them.
void begin_focus_layer();
// Adds the last item to those that Tab reaches. Returns whether Enter was pressed on it.
bool focus_stop();
// Adds the last item, into which text is typed.
void focus_stop_for_text();
// Whether a control other than a text field has the ring, so that Enter is for it.
bool control_focused();

}  // namespace cambrian
