#pragma once

// One row of the table of settings, and the builder of rows. All rows are in
// fields/setting_field.h.

#include "core/result.h"
#include "core/text/pretty_text.h"
#include "evolution/settings/experiment_settings.h"
#include "evolution/settings/kind_parameter.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <tuple>
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
    std::vector<std::string> choices = {};  // allowed values of a text
    std::string format = {};                // of a text without choices, in words
    // Returns what is wrong with such a text.
    std::function<Status(const std::string&)> check_text = {};
    std::vector<std::string> choice_labels = {};  // their displayed names, in the same order
    bool logarithmic = false;                     // whether a slider should be logarithmic
    // Whether it may change during a run, from the next generation on. Otherwise it defines the run
    // and a change starts a new one.
    bool live = true;
    // Whether the run itself changes it. Users do not edit it.
    bool by_run = false;
    // Whether it was introduced after files that do not contain it. Creature files and digests of
    // settings leave it out while it has the default of all goals.
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

// Returns the settings themselves, or their part of that type.
template <class Part>
Part& part_of(Settings& s) {
    return std::get<Part&>(std::tie(s, s.world.environment, s.world.environment.terrain,
                                    s.world.scene, s.world.trial, s.population, s.selection,
                                    s.mutation, s.breeding, s.founders, s.expression, s.preserve));
}

// Adds the fields of one table. The value of a field is a member of the settings or of a part of
// them, the parameter of a selection, or what a function returns a reference to in a Settings&.
class TableBuilder {
public:
    TableBuilder(std::vector<SettingField>& fields, std::string table)
        : fields_(fields), table_(std::move(table)) {}

    // Adds a number.
    template <class At>
    SettingField& number(At at, std::string key, std::string label, std::string unit, Range range,
                         std::string help) {
        return append(at, std::move(key), std::move(label), std::move(unit), range,
                      std::move(help));
    }
    template <class At>
    SettingField& flag(At at, std::string key, std::string label, std::string help) {
        return append(at, std::move(key), std::move(label), "", Range{0.0, 1.0}, std::move(help));
    }
    template <class At>
    SettingField& choice(At at, std::string key, std::string label,
                         std::vector<std::string> choices, std::string help) {
        SettingField& field =
            append(at, std::move(key), std::move(label), "", Range{}, std::move(help));
        field.choices = std::move(choices);
        for (const std::string& choice : field.choices)
            field.choice_labels.push_back(label_of(choice));
        return field;
    }
    // Adds a choice among kinds, each of which has an id and a label.
    template <class At, class Kinds>
    SettingField& kind_choice(At at, std::string key, std::string label, const Kinds& kinds,
                              std::string help) {
        SettingField& field =
            append(at, std::move(key), std::move(label), "", Range{}, std::move(help));
        for (const auto& kind : kinds) {
            field.choices.push_back(kind.id);
            field.choice_labels.push_back(kind.label);
        }
        return field;
    }

private:
    // Converts "count-first" to "Count first".
    static std::string label_of(std::string id) {
        std::replace(id.begin(), id.end(), '-', ' ');
        return capitalized(std::move(id));
    }

    template <class Part, class Value>
    static auto place(Value Part::*member) {
        return
            [member](Settings& settings) { return SettingRef(&(part_of<Part>(settings).*member)); };
    }
    template <class Value>
    static auto place(KindParameter<Value> parameter) {
        return [parameter](Settings& settings) {
            return SettingRef(&parameter.in(settings.selection.own));
        };
    }
    template <class At>
    static auto place(At at) {
        return [at](Settings& settings) { return SettingRef(&at(settings)); };
    }
    template <class At>
    SettingField& append(At at, std::string key, std::string label, std::string unit, Range range,
                         std::string help) {
        SettingField field;
        field.table = table_;
        field.key = std::move(key);
        field.label = std::move(label);
        field.unit = std::move(unit);
        field.help = std::move(help);
        field.low = range.low;
        field.high = range.high;
        field.at = place(at);
        fields_.push_back(std::move(field));
        return fields_.back();
    }

    std::vector<SettingField>& fields_;
    std::string table_;
};

}  // namespace cambrian::setting_table
