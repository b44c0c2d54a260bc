#include "persist/records/picking_record.h"

#include <fmt/core.h>

#include <charconv>

namespace cambrian {

std::string picks_text(std::span<const std::size_t> picks) {
    std::string text;
    for (const std::size_t cell : picks)
        text += fmt::format("{}{}", text.empty() ? "" : " ", cell);
    return text;
}

std::optional<std::vector<std::size_t>> parse_picks(std::string_view text) {
    std::vector<std::size_t> picks;
    const char* at = text.data();
    const char* end = at + text.size();
    while (at != end) {
        if (!picks.empty() && *at++ != ' ') return std::nullopt;
        std::size_t cell = 0;
        const auto [next, error] = std::from_chars(at, end, cell);
        if (error != std::errc() || picks.size() == kMostPicks) return std::nullopt;
        picks.push_back(cell);
        at = next;
    }
    return picks;
}

}  // namespace cambrian
