#pragma once

// One setting as a typed value, independent of the file: settings files and the scores in creature
// files share it.

#include "evolution/fields/setting_field.h"

#include <cstdint>
#include <string>
#include <variant>

namespace cambrian {

// As found in a file; monostate for anything a setting cannot be.
using SettingValue = std::variant<std::monostate, bool, std::int64_t, double, std::string>;

enum class SettingFault : std::uint8_t { kNone, kType, kRange, kChoice };

struct SettingCheck {
    SettingFault fault = SettingFault::kNone;
    std::string message;  // "expected a number, found a text", "2000 is outside [0, 1000]"
};

// Stores the value in the settings if it is of the field's type and in its range.
SettingCheck assign(const SettingField& field, const SettingValue& value,
                    ExperimentSettings& settings);

SettingValue value_of(const SettingField& field, const ExperimentSettings& settings);

// The value as TOML and JSON both write it.
std::string setting_text(const SettingValue& value);

}  // namespace cambrian
