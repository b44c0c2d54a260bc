#include "evolution/tuned_parents.h"

#include "core/assert.h"
#include "evolution/selections/survival.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace cambrian {
namespace {

constexpr double kLeastHeadWeight = 0.1;

// Returns the best survivor of each line, best first.
std::vector<std::size_t> heads_of_lines(std::span<const IndividualPtr> ranked,
                                        std::span<const std::size_t> survivors) {
    std::vector<std::size_t> heads;
    std::set<std::uint64_t> lines;
    for (const std::size_t survivor : survivors) {
        if (lines.insert(ranked[survivor]->line).second) heads.push_back(survivor);
    }
    return heads;
}

}  // namespace

std::vector<std::optional<std::size_t>> draw_tuned_parents(std::span<const IndividualPtr> ranked,
                                                           std::span<const std::size_t> survivors,
                                                           std::size_t children, double share,
                                                           RandomStream& stream) {
    CAMBRIAN_ASSERT(!survivors.empty(), "somebody survives");
    std::vector<std::optional<std::size_t>> parents(children);
    if (!(share > 0.0)) return parents;
    const std::vector<std::size_t> heads = heads_of_lines(ranked, survivors);
    const std::vector<double> lead = leads(ranked, survivors);
    std::vector<double> weights;
    for (const std::size_t head : heads) {
        const auto place = std::find(survivors.begin(), survivors.end(), head);
        weights.push_back(kLeastHeadWeight +
                          lead[static_cast<std::size_t>(place - survivors.begin())]);
    }
    for (std::optional<std::size_t>& parent : parents) {
        if (stream.chance(share)) parent = heads[stream.weighted(weights)];
    }
    return parents;
}

}  // namespace cambrian
