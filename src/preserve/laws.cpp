#include "preserve/laws.h"

#include "core/assert.h"
#include "core/text/number_text.h"
#include "core/text/parsed_number.h"
#include "evolution/settings/goal_defaults.h"
#include "preserve/replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

namespace cambrian {
namespace {

constexpr std::string_view kLawPrefix = intervention::kLaw;

// "table.key" of each, in the order of display.
constexpr std::array kLaws = {"preserve.growth-time",
                              "preserve.plant-energy",
                              "preserve.flesh-half-life",
                              "preserve.body-upkeep",
                              "preserve.neuron-upkeep",
                              "preserve.organ-upkeep",
                              "preserve.aging-time",
                              "preserve.bite-power",
                              "preserve.birth-interval",
                              "preserve.max-population",
                              "preserve.restock",
                              "mutation.rate",
                              "environment.viscosity-linear",
                              "environment.viscosity-quadratic"};

std::string name_of(const SettingField& field) {
    return field.table + "." + field.key;
}

std::vector<std::string> law_names(std::span<const SettingField> laws) {
    std::vector<std::string> names;
    std::transform(laws.begin(), laws.end(), std::back_inserter(names), name_of);
    return names;
}

Status set_law(const SettingField& law, double value, ExperimentSettings& settings) {
    const SettingRef at = law.at(settings);
    auto* const* whole = std::get_if<int*>(&at);
    const bool fits = value >= law.low && value <= law.high;
    if (!fits || (whole != nullptr && value != std::floor(value)))
        return Error{fmt::format("{}: {} is not a {} from {} to {}{}{}", law.label,
                                 short_text(value), whole == nullptr ? "number" : "whole number",
                                 short_text(law.low), short_text(law.high),
                                 law.unit.empty() ? "" : " ", law.unit)};
    if (whole != nullptr) {
        **whole = static_cast<int>(value);
    } else {
        *std::get<double*>(at) = value;
    }
    return {};
}

// Returns the settings after the interventions that change laws.
Result<SettingsPtr> changed_by(const SettingsPtr& settings,
                               std::span<const Intervention> interventions,
                               const EvolutionKinds& kinds) {
    if (std::none_of(interventions.begin(), interventions.end(),
                     [](const Intervention& each) { return is_law(each.what); }))
        return settings;
    const std::vector<SettingField> laws = changeable_laws(kinds);
    auto changed = std::make_shared<ExperimentSettings>(*settings);
    for (const Intervention& each : interventions) {
        if (!is_law(each.what)) continue;
        const std::string name = each.what.substr(kLawPrefix.size());
        const auto law = std::find_if(laws.begin(), laws.end(), [&](const SettingField& field) {
            return name_of(field) == name;
        });
        if (law == laws.end())
            return Error{fmt::format("there is no law \"{}\" that can be changed; known are {}",
                                     name, fmt::join(law_names(laws), ", "))};
        if (Status set = set_law(*law, each.x, *changed); !set) return set.error();
        if (Status fits = check_preserve_memory(changed->preserve); !fits) return fits.error();
    }
    return SettingsPtr(std::move(changed));
}

}  // namespace

std::vector<SettingField> changeable_laws(const EvolutionKinds& kinds) {
    std::vector<SettingField> laws;
    const std::vector<SettingField> fields = preserve_fields(kinds);
    for (const char* name : kLaws) {
        const auto found =
            std::find_if(fields.begin(), fields.end(),
                         [&](const SettingField& field) { return name_of(field) == name; });
        CAMBRIAN_ASSERT(found != fields.end(), "a law is a setting");
        laws.push_back(*found);
        laws.back().live = true;
    }
    return laws;
}

double law_value(const SettingField& law, ExperimentSettings& settings) {
    const SettingRef at = law.at(settings);
    auto* const* whole = std::get_if<int*>(&at);
    return whole != nullptr ? **whole : *std::get<double*>(at);
}

bool is_law(std::string_view what) {
    return what.starts_with(kLawPrefix);
}

Intervention law_change(const SettingField& law, double value) {
    return {.what = intervention::kLaw + name_of(law), .x = value};
}

Result<Intervention> law_change_of(std::string_view text) {
    const std::size_t sign = std::min(text.find('='), text.size());
    const auto value = parsed_number<double>(text.substr(std::min(sign + 1, text.size())));
    if (sign == 0 || !value || !std::isfinite(*value))
        return Error{"expected the name of a law and a number, as preserve.growth-time=60"};
    return Intervention{.what = intervention::kLaw + std::string(text.substr(0, sign)),
                        .x = *value};
}

Result<SettingsPtr> with_law(const SettingsPtr& settings, const Intervention& change,
                             const EvolutionKinds& kinds) {
    return changed_by(settings, std::span(&change, 1), kinds);
}

Result<SettingsPtr> laws_at(const SettingsPtr& founding,
                            std::span<const Intervention> interventions, std::uint64_t tick,
                            const EvolutionKinds& kinds) {
    return changed_by(founding, interventions_up_to(interventions, tick), kinds);
}

SettingsPtr trial_settings(const SettingsPtr& laws, const EvolutionKinds& kinds) {
    ExperimentSettings settings = *laws;
    adopt_possible_goal(settings, kinds.goals);
    return std::make_shared<const ExperimentSettings>(std::move(settings));
}

}  // namespace cambrian
