#include "persist/records/picking_record.h"

#include "core/text/parsed_number.h"

#include <fmt/format.h>

namespace cambrian {

std::string picks_text(std::span<const std::size_t> picks) {
    return fmt::format("{}", fmt::join(picks, " "));
}

std::optional<std::vector<std::size_t>> parse_picks(std::string_view text) {
    return parsed_numbers<std::size_t>(text, kMostPicks);
}

}  // namespace cambrian
