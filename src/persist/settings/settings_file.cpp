#include "persist/settings/settings_file.h"

#include "core/files/file_io.h"
#include "evolution/settings/goal_defaults.h"

namespace cambrian {
namespace {

constexpr std::size_t kMaxBytes = 1'000'000;

}  // namespace

ExperimentSettings default_settings(std::string_view goal, const EvolutionKinds& kinds) {
    const bool in_space = kinds.creature.scene.dimensions == 3;
    ExperimentSettings settings;
    if (in_space) settings.goal = kGoalOfSpace;
    if (!goal.empty()) settings.goal = goal;
    if (const GoalKind* kind = kinds.goals.find(settings.goal); kind != nullptr)
        adopt_defaults(settings, *kind);
    if (in_space) adopt_space(settings.world);
    return settings;
}

Result<ExperimentSettings> load_settings(const std::filesystem::path& path,
                                         const EvolutionKinds& kinds, SettingsUse use) {
    const Result<SettingsText> text = read_settings_text(path);
    if (!text) return text.error();
    return parse_settings(text->text, text->source, kinds, use);
}

Result<SettingsText> read_settings_text(const std::filesystem::path& path) {
    Result<std::string> text = read_file(path, kMaxBytes);
    if (!text) return text.error();
    return SettingsText{*std::move(text), path.string()};
}

Status save_settings(const std::filesystem::path& path, const ExperimentSettings& settings,
                     const EvolutionKinds& kinds) {
    return write_file(path, write_settings(settings, kinds));
}

}  // namespace cambrian
