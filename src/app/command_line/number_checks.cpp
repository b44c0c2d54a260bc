#include "app/command_line/number_checks.h"

#include "core/text/number_text.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>

namespace cambrian {
namespace {

// Returns nothing if the text is not a number, and infinity if the number is too large.
std::optional<double> number_of(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0.0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    if (parsed.ptr != end || parsed.ec == std::errc::invalid_argument) return std::nullopt;
    return parsed.ec == std::errc() ? number : HUGE_VAL;
}

std::string range_text(double low, double high) {
    return fmt::format("[{}, {}]", short_text(low), short_text(high));
}

// Returns an error message; empty if the number is in the range.
std::string fault(const std::string& typed, double low, double high) {
    const std::optional<double> number = number_of(typed);
    if (!number) return fmt::format("'{}' is not a number", typed);
    if (!std::isfinite(*number)) return typed + " is not finite";
    if (*number >= low && *number <= high) return "";
    return fmt::format("{} is outside {}", typed, range_text(low, high));
}

std::string described(const char* sort, double low, double high) {
    return fmt::format("{} in [{} - {}]", sort, short_text(low), short_text(high));
}

}  // namespace

void take_whole(CLI::Option& option, std::int64_t low, std::int64_t high) {
    const auto least = static_cast<double>(low);
    const auto most = static_cast<double>(high);
    const auto check = [least, most](std::string& text) {
        std::string wrong = fault(text, least, most);
        if (!wrong.empty()) return wrong;
        const double number = *number_of(text);
        if (std::trunc(number) != number) return "expected a whole number, found " + text;
        text = std::to_string(static_cast<std::int64_t>(number));
        return std::string();
    };
    option.transform(CLI::Validator(check, described("INT", least, most)));
}

void take_real(CLI::Option& option, double low, double high) {
    const auto check = [low, high](std::string& text) { return fault(text, low, high); };
    option.check(CLI::Validator(check, described("FLOAT", low, high)));
}

void take_finite(CLI::Option& option) {
    const auto check = [](std::string& text) { return fault(text, -HUGE_VAL, HUGE_VAL); };
    option.check(CLI::Validator(check, ""));
}

}  // namespace cambrian
