#include "core/text/number_text.h"
#include "persist/settings/settings_file.h"
#include "persist/text/setting_value.h"

#include <fmt/format.h>

#include <type_traits>

namespace cambrian {
namespace {

constexpr std::size_t kCommentColumn = 30;

constexpr const char* kExperimentHead =
    "# The settings of one experiment: `cambrian evolve THIS-FILE` evolves under them.\n"
    "# A key left out has its default; those of [environment], [trial], confirmations and\n"
    "# stop-hopeless go with the goal.\n";
constexpr const char* kPreserveHead =
    "# The settings of one preserve: `cambrian preserve THIS-FILE` runs it.\n"
    "# A key left out has its default; those of bodies and [environment] go with ground.\n";

// Returns the allowed values in words: "0 to 1000 m/s^2", "walking, swimming".
std::string allowed(const SettingField& field, const SettingValue& value) {
    if (std::holds_alternative<bool>(value)) return "true or false";
    if (!std::holds_alternative<std::string>(value)) {
        const std::string range =
            fmt::format("{} to {}", short_text(field.low), short_text(field.high));
        return field.unit.empty() ? range : fmt::format("{} {}", range, field.unit);
    }
    if (field.check_text) return field.format;
    return fmt::format("{}", fmt::join(field.choices, ", "));
}

std::string comment(const SettingField& field, const SettingValue& value,
                    const ExperimentSettings& defaults) {
    return fmt::format("# {}; default {}. {}", allowed(field, value),
                       setting_text(value_of(field, defaults)), field.help);
}

std::string line(const SettingField& field, const ExperimentSettings& settings,
                 const ExperimentSettings& defaults) {
    const SettingValue value = value_of(field, settings);
    std::string text = fmt::format("{} = {} ", field.key, setting_text(value));
    if (text.size() < kCommentColumn) text.resize(kCommentColumn, ' ');
    return fmt::format("{}{}\n", text, comment(field, value, defaults));
}

}  // namespace

std::string write_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds,
                           SettingsUse use) {
    const bool preserve = use == SettingsUse::kPreserve;
    std::string text = preserve ? kPreserveHead : kExperimentHead;
    const ExperimentSettings defaults =
        preserve ? preserve_defaults(kinds, settings.world.environment.has_ground)
                 : default_settings(settings.goal, kinds);
    // The defaults of what decides the others.
    const ExperimentSettings base = preserve ? preserve_defaults(kinds) : ExperimentSettings{};
    std::string table;
    for (const SettingField& field : preserve ? preserve_fields(kinds) : setting_fields(kinds)) {
        if (field.table != table) text += fmt::format("\n[{}]\n", field.table);
        table = field.table;
        const bool decides = preserve ? field.key == "ground" : field.table == "goal";
        text += line(field, settings, decides ? base : defaults);
    }
    return text;
}

std::string digested_settings(const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    std::string text;
    for (const SettingField& field : setting_fields(kinds)) {
        const SettingValue value = value_of(field, settings);
        if (field.later && value == value_of(field, ExperimentSettings{})) continue;
        text += fmt::format("{} = {}\n", path_of(field), setting_text(value));
    }
    return text;
}

}  // namespace cambrian
