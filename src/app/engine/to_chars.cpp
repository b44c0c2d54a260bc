// std::to_chars() of numbers with a fraction, by {fmt}. The tables of libc++ for it are a quarter
// of the engine. The linker takes these functions instead.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace {

std::to_chars_result put(char* first, char* last, const std::string& text) {
    if (last - first < static_cast<std::ptrdiff_t>(text.size()))
        return {last, std::errc::value_too_large};
    return {std::copy(text.begin(), text.end(), first), std::errc()};
}

// The digits of a number that is not 0: 0.DIGITS times 10 to the point.
struct Decimal {
    bool negative = false;
    std::string digits;
    int point = 0;
};

Decimal decimal_of(const std::string& text) {
    Decimal number;
    const std::size_t e = std::min(text.find('e'), text.size());
    bool after_point = false;
    for (std::size_t i = 0; i < e; ++i) {
        if (text[i] == '-') number.negative = true;
        if (text[i] == '.') after_point = true;
        if (text[i] < '0' || text[i] > '9') continue;
        const bool leading = number.digits.empty() && text[i] == '0';
        if (!leading) number.digits += text[i];
        if (!leading && !after_point) ++number.point;
        if (leading && after_point) --number.point;
    }
    if (e < text.size()) number.point += std::atoi(text.c_str() + e + 1);
    number.digits.erase(number.digits.find_last_not_of('0') + 1);
    return number;
}

}  // namespace

_LIBCPP_BEGIN_NAMESPACE_STD

// Whole numbers are in the same object of libc++, which the linker takes whole or not at all.
namespace __itoa {

char* __u64toa(uint64_t value, char* buffer) noexcept {
    const fmt::format_int text(value);
    return std::copy_n(text.data(), text.size(), buffer);
}

char* __u32toa(uint32_t value, char* buffer) noexcept {
    return __u64toa(value, buffer);
}

}  // namespace __itoa

// The fewest digits that give the number, in the shorter of both notations.
to_chars_result to_chars(char* first, char* last, double value) {
    const std::string text = fmt::format("{}", value);
    if (!std::isfinite(value) || value == 0.0) return put(first, last, text);
    const Decimal number = decimal_of(text);
    const int count = static_cast<int>(number.digits.size());
    const std::string_view digits = number.digits;
    const std::string science =
        fmt::format("{}{}{}e{}{:02}", digits.substr(0, 1), count > 1 ? "." : "", digits.substr(1),
                    number.point < 1 ? '-' : '+', std::abs(number.point - 1));
    std::string fixed;
    if (number.point <= 0)
        fixed = "0." + std::string(static_cast<std::size_t>(-number.point), '0') + number.digits;
    else if (number.point >= count)
        fixed = fmt::format("{:.0f}", std::abs(value));
    else
        fixed = number.digits.substr(0, static_cast<std::size_t>(number.point)) + "." +
                number.digits.substr(static_cast<std::size_t>(number.point));
    const std::string& shorter = fixed.size() <= science.size() ? fixed : science;
    return put(first, last, (number.negative ? "-" : "") + shorter);
}

to_chars_result to_chars(char* first, char* last, double value, chars_format /*general*/,
                         int precision) {
    return put(first, last, fmt::format("{:.{}g}", value, precision));
}

_LIBCPP_END_NAMESPACE_STD
