#include "picking/grid/grid_hints.h"

#include "math/distance.h"
#include "picking/grid/grid_choice.h"

#include <algorithm>
#include <vector>

namespace cambrian {
namespace {

std::optional<std::size_t> index_of_greatest(const std::vector<double>& measures) {
    const auto most = std::max_element(measures.begin(), measures.end());
    if (most == measures.end() || !(*most > 0.0)) return std::nullopt;
    return static_cast<std::size_t>(most - measures.begin());
}

}  // namespace

GridHints grid_hints(std::span<const IndividualPtr> creatures) {
    const std::vector<GridDescriptor> descriptors = scaled_descriptors(creatures);
    std::vector<double> travels;
    std::vector<double> heights;
    std::vector<double> oddities;
    for (std::size_t i = 0; i < creatures.size(); ++i) {
        travels.push_back(creatures[i]->result.behavior.travel);
        heights.push_back(creatures[i]->result.behavior.settled_height);
        double sum = 0.0;
        for (const GridDescriptor& other : descriptors)
            sum += distance(descriptors[i], other);
        oddities.push_back(sum);
    }
    return {index_of_greatest(travels), index_of_greatest(heights), index_of_greatest(oddities)};
}

}  // namespace cambrian
