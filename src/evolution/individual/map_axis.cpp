#include "evolution/individual/map_axis.h"

#include "core/assert.h"
#include "math/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cambrian {
namespace {

double mass_of(const EvaluationResult& result) {
    return result.mass;
}

constexpr MapAxis kMassInSpace = {"mass", "Mass", 10, 0.5, 2000.0, true, mass_of};

constexpr std::array kAxes = {
    MapAxis{"parts", "Parts", 16, 0.5, 16.5, false,
            [](const EvaluationResult& result) { return static_cast<double>(result.parts); }},
    MapAxis{"mass", "Mass", 10, 0.02, 20.0, true, mass_of},
    MapAxis{"height", "Height / body length", 10, 0.0, 1.0, false,
            [](const EvaluationResult& result) {
                return result.body_length > 0.0
                           ? result.behavior.settled_height / result.body_length
                           : 0.0;
            }},
    MapAxis{"joints", "Movable joints", 16, -0.5, 15.5, false,
            [](const EvaluationResult& result) {
                return static_cast<double>(result.behavior.movable_joints);
            }},
    MapAxis{"contact", "Time on the ground", 10, 0.0, 1.0, false,
            [](const EvaluationResult& result) { return result.behavior.contact_share; }},
    MapAxis{"frequency", "Joint frequency", 10, 0.0, 5.0, false,
            [](const EvaluationResult& result) { return result.behavior.joint_frequency; }},
};

}  // namespace

std::span<const MapAxis> map_axes() {
    return kAxes;
}

const MapAxis& map_axis(std::string_view id, int dimensions) {
    if (dimensions == 3 && id == kMassInSpace.id) return kMassInSpace;
    const auto* const found = std::find_if(kAxes.begin(), kAxes.end(),
                                           [&](const MapAxis& axis) { return axis.id == id; });
    CAMBRIAN_ASSERT(found != kAxes.end(), "settings were checked");
    return *found;
}

int bin_on(const MapAxis& axis, const EvaluationResult& result) {
    const double x = axis.measure(result);
    const double share = axis.logarithmic ? logarithm(std::fmax(x, axis.low) / axis.low) /
                                                logarithm(axis.high / axis.low)
                                          : (x - axis.low) / (axis.high - axis.low);
    return static_cast<int>(std::clamp(std::floor(share * axis.bins), 0.0, axis.bins - 1.0));
}

MapCell cell_of(const EvaluationResult& result, const ExperimentSettings& settings) {
    const int dimensions = settings.world.environment.dimensions;
    return {bin_on(map_axis(settings.selection.map_across, dimensions), result),
            bin_on(map_axis(settings.selection.map_up, dimensions), result)};
}

MapCoverage map_coverage(std::span<const IndividualPtr> population,
                         const ExperimentSettings& settings) {
    std::map<MapCell, double> best;
    for (const IndividualPtr& individual : population) {
        if (individual->result.outcome != Outcome::kCompleted) continue;
        double& fitness =
            best.try_emplace(cell_of(individual->result, settings), 0.0).first->second;
        fitness = std::max(fitness, individual->result.fitness);
    }
    MapCoverage coverage;
    coverage.filled_cells = static_cast<int>(best.size());
    for (const auto& [cell, fitness] : best)
        coverage.quality += fitness;
    return coverage;
}

}  // namespace cambrian
