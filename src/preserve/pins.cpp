#include "preserve/pins.h"

#include "core/text/parsed_number.h"

#include <cstddef>

namespace cambrian {
namespace {

constexpr std::size_t kMostPins = 100'000;

}  // namespace

std::string pins_text(const Pins& pins) {
    std::string text = pins.inherited ? "1" : "0";
    for (const std::uint64_t number : pins.creatures)
        text += " " + std::to_string(number);
    return text;
}

std::optional<Pins> pins_of(std::string_view text) {
    const auto numbers = parsed_numbers<std::uint64_t>(text, kMostPins + 1);
    if (!numbers || numbers->empty() || numbers->front() > 1) return std::nullopt;
    return Pins{.creatures = {numbers->begin() + 1, numbers->end()},
                .inherited = numbers->front() == 1};
}

}  // namespace cambrian
