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
        const EvaluationResult& result = creatures[i]->result;
        const bool completed = result.outcome == Outcome::kCompleted;
        travels.push_back(completed ? result.behavior.travel : 0.0);
        heights.push_back(completed ? result.behavior.settled_height : 0.0);
        double sum = 0.0;
        for (const GridDescriptor& other : descriptors)
            sum += distance(descriptors[i], other);
        oddities.push_back(completed ? sum : 0.0);
    }
    return {index_of_greatest(travels), index_of_greatest(heights), index_of_greatest(oddities)};
}

}  // namespace cambrian
