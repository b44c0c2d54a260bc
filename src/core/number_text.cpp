#include "core/number_text.h"

#include <array>
#include <charconv>

namespace cambrian {

std::string short_text(double number) {
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    return {buffer.data(), end};
}

std::string real_text(double number) {
    std::string text = short_text(number);
    const bool whole = text.find_first_of(".en") == std::string::npos;
    return whole ? text + ".0" : text;
}

}  // namespace cambrian
