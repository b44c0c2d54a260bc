#include "evolution/fields/setting_changes.h"

#include "core/text/pretty_text.h"

#include <algorithm>
#include <type_traits>

namespace cambrian {

bool same_value(const SettingField& field, ExperimentSettings& a, ExperimentSettings& b) {
    const SettingRef at_b = field.at(b);
    return std::visit(
        [&at_b](const auto* value) {
            return *value == **std::get_if<std::remove_cvref_t<decltype(*value)>*>(&at_b);
        },
        field.at(a));
}

std::string choice_text(const SettingField& field, const std::string& value) {
    const auto found = std::find(field.choices.begin(), field.choices.end(), value);
    if (found == field.choices.end()) return value;
    return field.choice_labels[static_cast<std::size_t>(found - field.choices.begin())];
}

std::string value_text(const SettingField& field, const SettingRef& ref) {
    return std::visit(
        [&field](const auto* value) -> std::string {
            using T = std::remove_cvref_t<decltype(*value)>;
            if constexpr (std::is_same_v<T, std::string>) {
                return choice_text(field, *value);
            } else if constexpr (std::is_same_v<T, bool>) {
                return *value ? "on" : "off";
            } else {
                return with_unit(static_cast<double>(*value), field.unit);
            }
        },
        ref);
}

void copy_value(const SettingField& field, ExperimentSettings& from, ExperimentSettings& to) {
    const SettingRef source = field.at(from);
    std::visit(
        [&source](auto* value) {
            *value = **std::get_if<std::remove_cvref_t<decltype(*value)>*>(&source);
        },
        field.at(to));
}

ExperimentSettings with_live_fields(const ExperimentSettings& running,
                                    const ExperimentSettings& draft,
                                    const std::vector<SettingField>& fields) {
    ExperimentSettings result = running;
    ExperimentSettings source = draft;
    for (const SettingField& field : fields) {
        if (field.live) copy_value(field, source, result);
    }
    return result;
}

std::vector<std::string> structural_changes(const ExperimentSettings& running,
                                            const ExperimentSettings& draft,
                                            const std::vector<SettingField>& fields) {
    ExperimentSettings a = running;
    ExperimentSettings b = draft;
    std::vector<std::string> labels;
    for (const SettingField& field : fields) {
        if (!field.live && !field.by_run && !same_value(field, a, b)) labels.push_back(field.label);
    }
    return labels;
}

}  // namespace cambrian
