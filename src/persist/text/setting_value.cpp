#include "persist/text/setting_value.h"

#include "core/text/nearest_name.h"
#include "core/text/number_text.h"
#include "persist/text/error_list.h"
#include "persist/text/quoted_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace cambrian {
namespace {

// Names of the types, in the order of SettingValue.
constexpr const char* kFound[] = {"something else", "true or false", "a whole number", "a number",
                                  "a text"};

SettingCheck wrong_type(const char* expected, const SettingValue& value) {
    return {SettingFault::kType,
            fmt::format("expected {}, found {}", expected, kFound[value.index()])};
}

SettingCheck check_range(const SettingField& field, double number) {
    if (number >= field.low && number <= field.high) return {};
    std::string message = fmt::format("{} is outside [{}, {}]", short_text(number),
                                      short_text(field.low), short_text(field.high));
    if (!field.unit.empty()) message += " " + field.unit;
    return {SettingFault::kRange, std::move(message)};
}

SettingCheck assign_to(bool& place, const SettingField& /*field*/, const SettingValue& value) {
    const bool* flag = std::get_if<bool>(&value);
    if (flag == nullptr) return wrong_type("true or false", value);
    place = *flag;
    return {};
}

SettingCheck assign_to(double& place, const SettingField& field, const SettingValue& value) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    const auto* real = std::get_if<double>(&value);
    if (whole == nullptr && real == nullptr) return wrong_type("a number", value);
    const double number = real != nullptr ? *real : static_cast<double>(*whole);
    SettingCheck check = check_range(field, number);
    if (check.fault == SettingFault::kNone) place = number;
    return check;
}

// Assigns to int and std::uint64_t.
template <class Integer>
SettingCheck assign_to(Integer& place, const SettingField& field, const SettingValue& value) {
    const auto* whole = std::get_if<std::int64_t>(&value);
    const auto* real = std::get_if<double>(&value);
    // Large integers may have an exponent: 1e+15.
    const bool comes_to_whole =
        real != nullptr && std::isfinite(*real) && std::trunc(*real) == *real;
    if (whole == nullptr && !comes_to_whole) return wrong_type("a whole number", value);
    const double number = whole != nullptr ? static_cast<double>(*whole) : *real;
    SettingCheck check = check_range(field, number);
    if (check.fault == SettingFault::kNone)
        place = whole != nullptr ? static_cast<Integer>(*whole) : static_cast<Integer>(*real);
    return check;
}

SettingCheck assign_to(std::string& place, const SettingField& field, const SettingValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) return wrong_type("a text", value);
    if (field.check_text) {
        if (Status sound = field.check_text(*text); !sound)
            return {SettingFault::kChoice, sound.error().message};
        place = *text;
        return {};
    }
    if (std::find(field.choices.begin(), field.choices.end(), *text) != field.choices.end()) {
        place = *text;
        return {};
    }
    std::string message = "unknown " + in_quotes(*text);
    const std::string near = nearest_name(*text, field.choices);
    if (!near.empty()) {
        message += fmt::format("; did you mean \"{}\"?", near);
    } else {
        message += "; known are";
        for (const std::string& choice : field.choices)
            message += (choice == field.choices.front() ? " " : ", ") + choice;
    }
    return {SettingFault::kChoice, std::move(message)};
}

}  // namespace

SettingCheck assign(const SettingField& field, const SettingValue& value,
                    ExperimentSettings& settings) {
    return std::visit([&](auto* place) { return assign_to(*place, field, value); },
                      field.at(settings));
}

SettingValue value_of(const SettingField& field, const ExperimentSettings& settings) {
    ExperimentSettings copy = settings;
    return std::visit(
        [](const auto* place) -> SettingValue {
            using T = std::remove_cvref_t<decltype(*place)>;
            if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
                return static_cast<std::int64_t>(*place);
            } else {
                return *place;
            }
        },
        field.at(copy));
}

std::string setting_text(const SettingValue& value) {
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
    if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
    if (const auto* real = std::get_if<double>(&value)) return real_text(*real);
    if (const auto* text = std::get_if<std::string>(&value)) return quoted_text(*text);
    return {};
}

}  // namespace cambrian
