#pragma once

// The settings as edited by hand, with undo and redo as values. The engine has its own,
// which follow between generations.

#include "evolution/fields/setting_field.h"

#include <optional>
#include <string>
#include <vector>

namespace cambrian {

class SettingsEditor {
public:
    explicit SettingsEditor(ExperimentSettings settings) : draft_(std::move(settings)) {}

    const ExperimentSettings& draft() const { return draft_; }

    // Replaces the draft. Edits of the same field without a finish() between them, as a drag makes
    // them, are one step to undo.
    void edit(ExperimentSettings settings, const std::string& field);
    void finish() { open_field_.clear(); }
    bool can_undo() const { return !past_.empty(); }
    bool can_redo() const { return !future_.empty(); }
    void undo();
    void redo();
    // Other settings altogether, of a file or a new run; nothing to undo.
    void replace(ExperimentSettings settings);

private:
    ExperimentSettings draft_;
    std::vector<ExperimentSettings> past_;
    std::vector<ExperimentSettings> future_;
    std::string open_field_;  // being edited, or empty
};

// Equality of what two settings say through the fields: texts, numbers, flags.
bool same_value(const SettingField& field, ExperimentSettings& a, ExperimentSettings& b);
// Copies one field's value.
void copy_value(const SettingField& field, ExperimentSettings& from, ExperimentSettings& to);

// `running` with all live fields taken from `draft`: what may change while it runs.
ExperimentSettings with_live_fields(const ExperimentSettings& running,
                                    const ExperimentSettings& draft,
                                    const std::vector<SettingField>& fields);

// Labels of fields that differ and cannot change while running.
std::vector<std::string> structural_changes(const ExperimentSettings& running,
                                            const ExperimentSettings& draft,
                                            const std::vector<SettingField>& fields);

}  // namespace cambrian
