#pragma once

// Reads numbers from text, in the same way under every locale.

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace cambrian {

// Returns nothing unless the complete text is one number that the type can hold.
template <class Number>
std::optional<Number> parsed_number(std::string_view text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
    return number;
}

// Reads numbers with one space between neighbours. Returns nothing for other text and for more than
// `most` numbers.
template <class Number>
std::optional<std::vector<Number>> parsed_numbers(std::string_view text, std::size_t most) {
    std::vector<Number> numbers;
    for (bool more = !text.empty(); more;) {
        const std::size_t space = text.find(' ');
        const auto number = parsed_number<Number>(text.substr(0, space));
        if (!number || numbers.size() == most) return std::nullopt;
        numbers.push_back(*number);
        more = space != std::string_view::npos;
        text.remove_prefix(more ? space + 1 : text.size());
    }
    return numbers;
}

}  // namespace cambrian
