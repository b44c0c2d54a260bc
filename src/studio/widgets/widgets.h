#pragma once

// Controls shared by the panels. Each that can be pressed notes its place under its label.

#include "studio/look/icons.h"
#include "studio/look/ui_context.h"

#include <string>
#include <vector>

namespace cambrian {

enum class ButtonLook : unsigned char { kPlain, kPrimary, kGhost, kSelected };

struct ButtonStyle {
    ButtonLook look = ButtonLook::kPlain;
    Icon icon = Icon::kNone;
    bool label_shown = true;  // otherwise the label only names it
    float width = 0.0F;       // pixels; 0 is as wide as its content
    float height = 0.0F;      // pixels; 0 is a line with padding
    bool enabled = true;
    const char* tooltip = nullptr;
};

// True when pressed.
bool push_button(const std::string& label, const ButtonStyle& style = {});

// A card's cross at the right end of the present line; true when pressed.
bool close_button(const std::string& label);

// An on/off switch; true when flipped.
bool toggle_switch(const std::string& label, bool& on);

// A row of choices, one of which is chosen; the index pressed, or -1. In the small font where there
// is no room, and in several lines where that is not enough. Tooltips go with the labels.
int segmented(const std::string& name, const std::vector<std::string>& labels, int chosen,
              const std::vector<std::string>& tooltips = {});

// As ImGui::BeginCombo, with a chevron like all else here; ImGui::EndCombo() ends it.
bool begin_choice(const char* id, const std::string& shown, float width);

// A menu's entry; true when pressed.
bool menu_item(const char* label, const char* keys, bool enabled = true, bool chosen = false);

// Small words above a part of a panel.
void caption(const std::string& text);
// A panel's name, at its top.
void panel_title(const std::string& text);
// A line across, and the name of what follows.
void section(const char* title);
// "label   value" on one line, the value to the right.
void fact(const std::string& label, const std::string& value);
// Text in the small font and muted colour, wrapped.
void muted_text(const std::string& text);
// A progress bar filling the line's remaining width, or `width` pixels.
void progress_bar(float share, float width, float height);
// On the last item, after a moment under the mouse.
void tooltip(const std::string& text);
// Text cut off with an ellipsis to fit.
std::string fit_text(const std::string& text, float width);

}  // namespace cambrian
