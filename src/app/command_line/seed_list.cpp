#include "app/command_line/seed_list.h"

#include "core/text/parsed_number.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>

namespace cambrian {
namespace {

std::optional<std::uint64_t> parse_seed(std::string_view text) {
    const auto seed = parsed_number<std::uint64_t>(text);
    return seed && *seed <= std::uint64_t{kMostSeed} ? seed : std::nullopt;
}

}  // namespace

Result<std::vector<std::uint64_t>> parse_seeds(std::string_view text) {
    const std::string whole(text);
    std::set<std::uint64_t> seeds;
    for (bool more = true; more;) {
        const std::size_t comma = text.find(',');
        const std::string_view part = text.substr(0, comma);
        more = comma != std::string_view::npos;
        text.remove_prefix(more ? comma + 1 : text.size());
        const std::size_t dots = part.find("..");
        const auto first = parse_seed(part.substr(0, dots));
        const auto last =
            dots == std::string_view::npos ? first : parse_seed(part.substr(dots + 2));
        if (!first || !last || *last < *first)
            return Error{
                fmt::format("'{}' is not a list of seeds; expected 7, 1..9 or 1..9,12", whole)};
        for (std::uint64_t seed = *first; seed <= *last && seeds.size() <= kMostSeeds; ++seed)
            seeds.insert(seed);
        if (seeds.size() > kMostSeeds)
            return Error{fmt::format("'{}' has more than {} seeds", whole, kMostSeeds)};
    }
    return std::vector<std::uint64_t>(seeds.begin(), seeds.end());
}

}  // namespace cambrian
