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

// Draws the row and edits `settings` in place.
RowEvent setting_row(const SettingField& field, ExperimentSettings& settings,
                     ExperimentSettings& defaults);

}  // namespace cambrian
