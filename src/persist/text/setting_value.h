#pragma once

// The value of one setting, independent of the file format. Settings files and the scores in
// creature files use it.

#include "evolution/fields/setting_field.h"

#include <cstdint>
#include <string>
#include <variant>

namespace cambrian {

// A value as read from a file; monostate means any type that a setting cannot have.
using SettingValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

enum class SettingFault : std::uint8_t { kNone, kType, kRange, kChoice };

struct SettingCheck {
    SettingFault fault = SettingFault::kNone;
    std::string message;  // "expected a number, found a text", "2000 is outside [0, 1000]"
};

// Stores the value in the settings if it has the field's type and is in its range.
SettingCheck assign(const SettingField& field, const SettingValue& value,
                    ExperimentSettings& settings);

SettingValue value_of(const SettingField& field, const ExperimentSettings& settings);

// Returns the value in the form common to TOML and JSON.
std::string setting_text(const SettingValue& value);

}  // namespace cambrian
