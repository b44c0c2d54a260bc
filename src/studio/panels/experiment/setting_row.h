#pragma once

// One setting as a row: name, control with unit, tooltip, mark when changed, right-click to reset.

#include "evolution/fields/setting_field.h"
#include "studio/look/ui_context.h"
#include "studio/widgets/value_slider.h"

#include <string>

namespace cambrian {

// The part of a number's range that its slider covers; beyond it numbers can be typed.
SliderRange slider_range(const SettingField& field, double standard, double present);

enum class RowEvent : unsigned char {
    kNone,
    kEdited,   // the settings were changed; more may follow as a drag goes on
    kFinished  // the control was released
};

// Draws the row and edits `settings` in place.
RowEvent setting_row(const SettingField& field, ExperimentSettings& settings,
                     ExperimentSettings& defaults);

}  // namespace cambrian
