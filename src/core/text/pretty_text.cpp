#include "core/text/pretty_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace cambrian {
namespace {

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
        text.replace(at, from.size(), to);
        at += to.size();
    }
}

// Groups digits by three, separated by thin spaces.
std::string grouped(long long whole) {
    std::string digits = std::to_string(std::llabs(whole));
    for (std::size_t end = digits.size(); end > 3; end -= 3)
        digits.insert(end - 3, " ");
    if (whole < 0) digits.insert(0, "−");
    return digits;
}

// Returns a text such as "−9.63 × 10⁻⁴".
std::string power_of_ten(double value) {
    constexpr std::array digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    const std::string text = fmt::format("{:.2e}", std::fabs(value));
    const std::size_t mark = text.find('e');
    const int exponent = std::stoi(text.substr(mark + 1));
    std::string raised = exponent < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(exponent)))
        raised += digits[static_cast<std::size_t>(digit - '0')];
    return fmt::format("{}{} × 10{}", value < 0.0 ? "−" : "", text.substr(0, mark), raised);
}

}  // namespace

std::string pretty_unit(const std::string& unit) {
    if (unit == "deg") return "°";
    if (unit == "x") return "×";
    std::string pretty = unit;
    replace_all(pretty, "^2", "²");
    replace_all(pretty, "^3", "³");
    return pretty;
}

std::string pretty_number(double value) {
    if (!std::isfinite(value)) return "–";
    const double size = std::fabs(value);
    if (size >= 1e7 || (size > 0.0 && size < 1e-3)) return power_of_ten(value);
    if (size >= 1000.0 || value == std::floor(value)) return grouped(std::llround(value));
    const int decimals = size >= 100.0 ? 1 : size >= 1.0 ? 2 : 3;
    std::string text = fmt::format("{:.{}f}", size, decimals);
    while (text.back() == '0')
        text.pop_back();
    if (text.back() == '.') text.pop_back();
    if (value < 0.0) text.insert(0, "−");
    return text;
}

std::string with_unit(double value, const std::string& unit) {
    const std::string pretty = pretty_unit(unit);
    if (pretty.empty()) return pretty_number(value);
    const bool tight = pretty == "°" || pretty == "×";
    return pretty_number(value) + (tight ? "" : " ") + pretty;
}

std::string measured(double value, const std::string& unit) {
    constexpr double nothing = 5e-4;
    return with_unit(std::fabs(value) < nothing ? 0.0 : value, unit);
}

std::string pretty_time(double seconds) {
    const auto whole = static_cast<long long>(std::ceil(std::fmax(0.0, seconds)));
    if (whole >= 3600) return fmt::format("{} h {:02}", whole / 3600, whole / 60 % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string capitalized(std::string text) {
    if (!text.empty()) {
        text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
    }
    return text;
}

std::string uncapitalized(std::string text) {
    if (!text.empty()) {
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    }
    return text;
}

}  // namespace cambrian
