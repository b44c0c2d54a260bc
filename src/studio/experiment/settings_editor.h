#pragma once

// The draft settings, as edited by the user, with undo and redo. The engine has its own copy, which
// gets the changes between generations.

#include "evolution/fields/setting_field.h"

#include <optional>
#include <string>
#include <vector>

namespace cambrian {

class SettingsEditor {
public:
    explicit SettingsEditor(ExperimentSettings settings) : draft_(std::move(settings)) {}

    const ExperimentSettings& draft() const { return draft_; }

    // Replaces the draft. Edits of the same field without a finish() between them, as during a
    // drag, are one step to undo.
    void edit(ExperimentSettings settings, const std::string& field);
    void finish() { open_field_.clear(); }
    // Returns the draft without the edit that is not finished.
    const ExperimentSettings& settled() const {
        return open_field_.empty() || past_.empty() ? draft_ : past_.back();
    }
    // Takes the last edit back, for good; does nothing if there is none.
    void refuse();
    bool can_undo() const { return !past_.empty(); }
    bool can_redo() const { return !future_.empty(); }
    void undo();
    void redo();
    // Replaces the draft by the settings of a file or a new run and clears the undo history.
    void replace(ExperimentSettings settings);

private:
    ExperimentSettings draft_;
    std::vector<ExperimentSettings> past_;
    std::vector<ExperimentSettings> future_;
    std::string open_field_;  // path of the field being edited, or empty
};

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
