#include "studio/comparison/comparison_draft.h"

#include "comparison/sweep.h"
#include "persist/settings/settings_file.h"
#include "persist/text/setting_value.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <variant>

namespace cambrian {
namespace {

constexpr std::size_t kMostSuggested = 4;
constexpr const char* kAsSet = "as set";  // name of the only arm if nothing is varied

// Splits at commas and removes the spaces around the parts. Empty parts are kept.
std::vector<std::string> parts_of(const std::string& text) {
    std::vector<std::string> parts(1);
    for (const char letter : text) {
        if (letter == ',') {
            parts.emplace_back();
        } else if (letter != ' ' || !parts.back().empty()) {
            parts.back() += letter;
        }
    }
    for (std::string& part : parts)
        part.erase(part.find_last_not_of(' ') + 1);
    return parts;
}

std::vector<SettingValue> numbers_around(const SettingField& field, double present, bool whole) {
    std::vector<SettingValue> values;
    const double step = present == 0.0 ? (field.high - field.low) / 4.0 : present;
    for (const double number : {present, present + step, present - 0.5 * step}) {
        const double held = std::clamp(number, field.low, field.high);
        values.push_back(whole ? SettingValue(static_cast<std::int64_t>(std::llround(held)))
                               : SettingValue(held));
    }
    return values;
}

std::vector<SettingValue> values_around(const SettingField& field, const SettingValue& present) {
    if (const auto* on = std::get_if<bool>(&present)) return {*on, !*on};
    if (const auto* whole = std::get_if<std::int64_t>(&present))
        return numbers_around(field, static_cast<double>(*whole), true);
    if (const auto* number = std::get_if<double>(&present))
        return numbers_around(field, *number, false);
    std::vector<SettingValue> values = {present};
    for (const std::string& choice : field.choices)
        values.emplace_back(choice);
    return values;
}

}  // namespace

bool may_vary(const SettingField& field) {
    const bool of_the_world = field.table == "environment" || field.key == "goal";
    const bool of_the_run = field.by_run || field.key == "seed";
    return !of_the_world && !of_the_run;
}

std::string suggested_values(const SettingField& field, const ExperimentSettings& settings) {
    std::vector<std::string> texts;
    for (const SettingValue& value : values_around(field, value_of(field, settings))) {
        const auto* word = std::get_if<std::string>(&value);
        std::string text = word != nullptr ? *word : setting_text(value);
        if (std::find(texts.begin(), texts.end(), text) != texts.end()) continue;
        texts.push_back(std::move(text));
        if (texts.size() == kMostSuggested) break;
    }
    return fmt::format("{}", fmt::join(texts, ", "));
}

Result<ComparisonPlan> plan_of(const ComparisonDraft& draft, const ExperimentSettings& settings,
                               const EvolutionKinds& kinds) {
    ComparisonPlan plan;
    plan.worlds = {{settings.goal, {{write_settings(settings, kinds), "the present settings"}}}};
    plan.random_search = draft.random_search;
    plan.trials = draft.trials;
    plan.seeds.resize(static_cast<std::size_t>(draft.seeds));
    std::iota(plan.seeds.begin(), plan.seeds.end(), std::uint64_t{1});
    if (draft.varied.empty()) {
        plan.arms = {{kAsSet, {}}};
        return plan;
    }
    auto arms = swept_arms({{"", {}}}, draft.varied, parts_of(draft.values), kinds);
    if (!arms) return arms.error();
    plan.arms = *std::move(arms);
    return plan;
}

}  // namespace cambrian
