#include "persist/settings/typed_setting.h"

#include "core/text/nearest_name.h"
#include "evolution/fields/setting_field.h"
#include "persist/text/error_list.h"
#include "persist/text/quoted_text.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

// Returns the fields that a name may mean: the one with that table and key or, without a table, all
// with that key.
std::vector<SettingField> fields_called(std::string_view name, const EvolutionKinds& kinds) {
    std::vector<SettingField> fields = setting_fields(kinds);
    std::erase_if(fields, [name](const SettingField& field) {
        return path_of(field) != name && field.key != name;
    });
    return fields;
}

std::string unknown_setting(std::string_view name, const EvolutionKinds& kinds) {
    std::vector<std::string> known;
    for (const SettingField& field : setting_fields(kinds)) {
        known.push_back(field.key);
        known.push_back(path_of(field));
    }
    const std::string near = nearest_name(name, known);
    return near.empty() ? "unknown setting; 'cambrian settings' lists them"
                        : fmt::format("unknown setting; did you mean \"{}\"?", near);
}

std::string several_settings(const std::vector<SettingField>& fields) {
    std::string words = "there are several; expected one of";
    for (const SettingField& field : fields)
        words += (&field == &fields.front() ? " " : ", ") + path_of(field);
    return words;
}

}  // namespace

Result<SettingsText> typed_setting(std::string_view assignment, const EvolutionKinds& kinds) {
    const std::string source = fmt::format("\"{}\"", shown(assignment));
    const std::size_t sign = assignment.find('=');
    if (sign == std::string_view::npos)
        return Error{source + ": expected a setting and its value, as selection.method=rank"};
    const std::string_view name = assignment.substr(0, sign);
    const std::string value(assignment.substr(sign + 1));
    const std::vector<SettingField> fields = fields_called(name, kinds);
    if (fields.empty()) return Error{fmt::format("{}: {}", source, unknown_setting(name, kinds))};
    if (fields.size() > 1) return Error{fmt::format("{}: {}", source, several_settings(fields))};
    const SettingField& field = fields.front();
    const bool words = !field.choices.empty() || field.check_text;
    const bool quoted = words && !value.starts_with('"');
    return SettingsText{
        fmt::format("[{}]\n{} = {}", field.table, field.key, quoted ? quoted_text(value) : value),
        source};
}

Result<ExperimentSettings> merge_typed(SettingsText begin,
                                       const std::vector<std::string>& assignments,
                                       const EvolutionKinds& kinds) {
    std::vector<SettingsText> texts = {std::move(begin)};
    for (const std::string& assignment : assignments) {
        Result<SettingsText> text = typed_setting(assignment, kinds);
        if (!text) return text.error();
        texts.push_back(*std::move(text));
    }
    return merge_settings(texts, kinds);
}

Result<ExperimentSettings> with_typed(ExperimentSettings settings,
                                      const std::vector<std::string>& assignments,
                                      const EvolutionKinds& kinds) {
    if (assignments.empty()) return settings;
    Result<ExperimentSettings> changed =
        merge_typed({write_settings(settings, kinds), "the settings"}, assignments, kinds);
    if (changed && changed->goal == settings.goal)
        changed->world.opponents = std::move(settings.world.opponents);  // they have no text
    return changed;
}

}  // namespace cambrian
