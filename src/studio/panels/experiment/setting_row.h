#pragma once

// One row for a setting: name, control with unit, tooltip, and a mark if changed. A right-click
// resets it.

#include "evolution/fields/setting_field.h"
#include "studio/look/ui_context.h"
#include "studio/widgets/value_slider.h"

#include <string>

namespace cambrian {

// Returns the part of a number's range that its slider covers. Numbers outside it can be typed.
SliderRange slider_range(const SettingField& field, double standard, double present);

enum class RowEvent : unsigned char {
    kNone,
    kEdited,   // the settings changed; more changes may follow during a drag
    kFinished  // the control was released
};

inline constexpr float kPlainControl = 100.0F;  // least width of a control in plain words

// Draws the row and edits `settings` in place. In plain words its name is "Grip (friction)".
RowEvent setting_row(const SettingField& field, ExperimentSettings& settings,
                     ExperimentSettings& defaults, bool in_plain_words = false);
// Draws only a name, over a width in pixels, with a mark if the value was changed. What is in
// brackets is muted.
void row_label(const std::string& label, bool changed, float width);

}  // namespace cambrian
