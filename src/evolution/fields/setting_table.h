#pragma once

// The builder of the rows in the table of settings, and the parts of the table that have files of
// their own.

#include "evolution/fields/setting_field.h"

#include <string>
#include <utility>
#include <vector>

namespace cambrian::setting_table {

using Settings = ExperimentSettings;

struct Range {
    double low = 0.0;
    double high = 0.0;
};

// Adds the fields of one table.
class TableBuilder {
public:
    TableBuilder(std::vector<SettingField>& fields, std::string table)
        : fields_(fields), table_(std::move(table)) {}

    // Adds a number. `at` returns a reference to the member of a Settings&.
    template <class At>
    SettingField& number(std::string key, std::string label, std::string unit, Range range,
                         std::string help, At at) {
        return append(std::move(key), std::move(label), std::move(unit), range, std::move(help),
                      at);
    }
    template <class At>
    SettingField& flag(std::string key, std::string label, std::string help, At at) {
        return append(std::move(key), std::move(label), "", Range{0.0, 1.0}, std::move(help), at);
    }
    template <class At>
    SettingField& choice(std::string key, std::string label, std::vector<std::string> choices,
                         std::string help, At at) {
        SettingField& field =
            append(std::move(key), std::move(label), "", Range{}, std::move(help), at);
        field.choices = std::move(choices);
        return field;
    }

private:
    template <class At>
    SettingField& append(std::string key, std::string label, std::string unit, Range range,
                         std::string help, At at) {
        SettingField field;
        field.table = table_;
        field.key = std::move(key);
        field.label = std::move(label);
        field.unit = std::move(unit);
        field.help = std::move(help);
        field.low = range.low;
        field.high = range.high;
        field.at = [at](Settings& settings) { return SettingRef(&at(settings)); };
        fields_.push_back(std::move(field));
        return fields_.back();
    }

    std::vector<SettingField>& fields_;
    std::string table_;
};

template <class Kind>
std::vector<std::string> ids_of(const Registry<Kind>& registry) {
    std::vector<std::string> ids;
    for (const Kind& kind : registry.all())
        ids.push_back(kind.id);
    return ids;
}

void add_trials(TableBuilder& trial);  // number of trials per creature and their jitter
// The settings that enable kinds of joints, neuron functions, sensors and references. The check
// fails if no movable joint or no control remains.
void add_body_kinds(std::vector<SettingField>& fields, const EvolutionKinds& kinds);
Status check_body_kinds(const Settings& settings, const EvolutionKinds& kinds);
void add_selection(std::vector<SettingField>& fields, const EvolutionKinds& kinds);

}  // namespace cambrian::setting_table
