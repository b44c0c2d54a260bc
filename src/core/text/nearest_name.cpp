#include "core/text/nearest_name.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

namespace cambrian {
namespace {

constexpr std::size_t kLongestName = 64;  // limits the work; all known names are shorter

// Computes the Levenshtein distance with one row of memory. Both texts have at most kLongestName
// bytes.
std::size_t edit_distance(std::string_view from, std::string_view to) {
    std::array<std::size_t, kLongestName + 1> row{};
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 1; i <= from.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= to.size(); ++j) {
            const std::size_t substituted = diagonal + (from[i - 1] == to[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
        }
    }
    return row[to.size()];
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> known) {
    if (name.size() > kLongestName) return {};
    std::string best;
    std::size_t best_distance = 0;
    for (const std::string& candidate : known) {
        if (candidate.size() > kLongestName) continue;
        const std::size_t distance = edit_distance(name, candidate);
        const std::size_t allowed =
            std::max<std::size_t>(1, std::max(name.size(), candidate.size()) / 3);
        if (distance > allowed || (!best.empty() && distance >= best_distance)) continue;
        best = candidate;
        best_distance = distance;
    }
    return best;
}

}  // namespace cambrian
