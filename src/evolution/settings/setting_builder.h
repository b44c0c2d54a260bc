#pragma once

// One row of the table of settings, and the builder of rows. All rows are in
// fields/setting_field.h.

#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace cambrian {

// A pointer to a member of an ExperimentSettings.
using SettingRef = std::variant<bool*, int*, std::uint64_t*, double*, std::string*>;

struct SettingField {
    std::string table;  // "environment"
    std::string key;    // "gravity"
    std::string label;  // "Gravity"
    std::string unit;   // "m/s^2", or empty
    std::string help;   // one sentence
    // Switches of one table with the same group are shown together, with one for all of them.
    std::string group = {};
    double low = 0.0;  // range of numbers, both ends included
    double high = 0.0;
    std::vector<std::string> choices;  // allowed values of a text
    bool logarithmic = false;          // whether a slider should be logarithmic
    // Whether it may change during a run, from the next generation on. Otherwise it defines the run
    // and a change starts a new one.
    bool live = true;
    // Moved on by the run itself: nobody edits it.
    bool by_run = false;
    // Younger than files that do not name it: left out of creature files and digests of settings
    // while it is at the default of all goals.
    bool later = false;
    // Returns whether the setting has an effect under the other settings; null means always.
    std::function<bool(const ExperimentSettings&)> applies;
    std::function<SettingRef(ExperimentSettings&)> at;
};

}  // namespace cambrian

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

}  // namespace cambrian::setting_table
