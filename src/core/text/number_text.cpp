#include "core/text/number_text.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace cambrian {

namespace {

constexpr double kLongestWhole = 1e15;

std::string shortest_text(double number) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    return {buffer.data(), end};
}

}  // namespace

std::string short_text(double number) {
    const bool whole = std::fabs(number) < kLongestWhole && std::trunc(number) == number;
    return whole ? std::to_string(static_cast<std::int64_t>(number)) : shortest_text(number);
}

std::string real_text(double number) {
    std::string text = shortest_text(number);
    const bool whole = text.find_first_of(".en") == std::string::npos;
    return whole ? text + ".0" : text;
}

}  // namespace cambrian
