#pragma once

// Values of settings: their words, and where two settings differ.

#include "evolution/fields/setting_field.h"

#include <string>
#include <vector>

namespace cambrian {

// Returns whether a field has the same value in both settings.
bool same_value(const SettingField& field, ExperimentSettings& a, ExperimentSettings& b);
// Returns a value in the words of the controls: "9.81 m/s²", "on", "Tournament".
std::string value_text(const SettingField& field, const SettingRef& value);
// Returns the label of a choice.
std::string choice_text(const SettingField& field, const std::string& value);
// Copies the value of one field.
void copy_value(const SettingField& field, ExperimentSettings& from, ExperimentSettings& to);

// Returns `running` with the fields that may change during a run taken from `draft`.
ExperimentSettings with_live_fields(const ExperimentSettings& running,
                                    const ExperimentSettings& draft,
                                    const std::vector<SettingField>& fields);

// Returns the labels of the fields that differ and cannot change during a run.
std::vector<std::string> structural_changes(const ExperimentSettings& running,
                                            const ExperimentSettings& draft,
                                            const std::vector<SettingField>& fields);

}  // namespace cambrian
