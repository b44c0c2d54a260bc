#pragma once

// Controls that panels share. Each control that can be pressed records its position under its
// label.

#include "studio/look/icons.h"
#include "studio/look/ui_context.h"

#include <string>
#include <vector>

namespace cambrian {

enum class ButtonLook : unsigned char { kPlain, kPrimary, kGhost, kSelected };

struct ButtonStyle {
    ButtonLook look = ButtonLook::kPlain;
    Icon icon = Icon::kNone;
    bool label_shown = true;  // false hides the label, which then only identifies the button
    float width = 0.0F;       // pixels; 0 fits the content
    float height = 0.0F;      // pixels; 0 is a line with padding
    bool enabled = true;
    const char* tooltip = nullptr;
};

// Returns true when pressed.
bool push_button(const std::string& label, const ButtonStyle& style = {});

// An on/off switch; returns true when it was flipped.
bool toggle_switch(const std::string& label, bool& on);

enum class Tick : unsigned char { kOff, kSome, kOn };

// A tick box for several things at once; returns true when pressed.
bool tick_box(const std::string& label, Tick tick);

// A row of choices, one of which is chosen. Returns the index pressed, or -1. Narrow rows use the
// small font and, if that is not enough, several lines. Each label has its tooltip, and may be one
// that cannot be chosen now.
int segmented(const std::string& name, const std::vector<std::string>& labels, int chosen,
              const std::vector<std::string>& tooltips = {},
              const std::vector<bool>& possible = {});

// Like ImGui::BeginCombo, with the studio's chevron. ImGui::EndCombo() ends it.
// A text that is too wide for it is shortened.
bool begin_choice(const char* id, const std::string& shown, float width);
// A line of an open choice; returns true when it was taken. The keyboard begins at the chosen one.
bool choice_line(const std::string& label, bool chosen);
// Returns the width, in pixels, in which begin_choice() shows a text completely.
float choice_width(const std::string& shown);

// A menu item; returns true when pressed.
bool menu_item(const char* label, const char* keys, bool enabled = true, bool chosen = false);

// Draws small text above a part of a panel.
void caption(const std::string& text);
// Draws a panel's name at its top.
void panel_title(const std::string& text);
// Draws a line and the title of the section below it.
void section(const char* title);
// Draws "label   value", with the value at the right: on the next line if there is no room beside
// the label.
void fact(const std::string& label, const std::string& value);
// Draws wrapped text in the small font and the muted colour.
void muted_text(const std::string& text);
// Draws a progress bar. Width 0 fills the rest of the line.
void progress_bar(float share, float width, float height);
// Sets up a column of a table. The width is in units of 1/96 inch; 0 takes the remaining width.
void set_up_column(const char* title, float width);

// Adds a tooltip to the last item, shown after a short delay.
void tooltip(const std::string& text);
// Returns the text, shortened with an ellipsis to fit a width.
std::string fit_text(const std::string& text, float width);

}  // namespace cambrian
