#pragma once

// The draft settings, as edited by the user, with undo and redo. The engine has its own copy, which
// gets the changes between generations.

#include "evolution/fields/setting_changes.h"

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

// Returns the settings that others are compared with to tell what the user changed.
ExperimentSettings plain_defaults(const EvolutionKinds& kinds);

}  // namespace cambrian
