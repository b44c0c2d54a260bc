#include "studio/experiment/settings_editor.h"

#include "evolution/settings/goal_defaults.h"

#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostSteps = 500;

}  // namespace

void SettingsEditor::edit(ExperimentSettings settings, const std::string& field) {
    if (settings == draft_) return;
    if (open_field_.empty() || open_field_ != field) {
        if (past_.size() == kMostSteps) past_.erase(past_.begin());
        past_.push_back(draft_);
    }
    open_field_ = field;
    future_.clear();
    draft_ = std::move(settings);
}

void SettingsEditor::refuse() {
    finish();
    if (past_.empty()) return;
    draft_ = std::move(past_.back());
    past_.pop_back();
}

void SettingsEditor::undo() {
    if (past_.empty()) return;
    finish();
    future_.push_back(std::exchange(draft_, past_.back()));
    past_.pop_back();
}

void SettingsEditor::redo() {
    if (future_.empty()) return;
    finish();
    past_.push_back(std::exchange(draft_, future_.back()));
    future_.pop_back();
}

void SettingsEditor::replace(ExperimentSettings settings) {
    finish();
    past_.clear();
    future_.clear();
    draft_ = std::move(settings);
}

ExperimentSettings plain_defaults(const EvolutionKinds& kinds) {
    ExperimentSettings settings;
    if (kinds.creature.scene.dimensions == 3) adopt_space_defaults(settings, kinds.goals);
    return settings;
}

}  // namespace cambrian
