#pragma once

// The measures that MAP-Elites uses as axes of its map (evolution/README.md 2).

#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace cambrian {

// Divides [low, high] into bins of equal width, or of equal ratio if logarithmic. Values outside go
// into the first or last bin.
struct MapAxis {
    std::string_view id;
    std::string_view label;
    int bins = 1;
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;
    double (*measure)(const EvaluationResult& result) = nullptr;
};

std::span<const MapAxis> map_axes();
// The id must be known. Masses have another range in three dimensions than in two.
const MapAxis& map_axis(std::string_view id, int dimensions = 2);

int bin_on(const MapAxis& axis, const EvaluationResult& result);

struct MapCell {
    int across = 0;
    int up = 0;

    friend bool operator==(const MapCell&, const MapCell&) = default;
    friend bool operator<(const MapCell& a, const MapCell& b) {
        return a.across != b.across ? a.across < b.across : a.up < b.up;
    }
};

MapCell cell_of(const EvaluationResult& result, const ExperimentSettings& settings);

// The coverage of the map by a population. `filled_cells` counts cells with a completed creature;
// `quality` is the QD-score, the sum of the best fitness, at least 0, of each.
struct MapCoverage {
    int filled_cells = 0;
    double quality = 0.0;
};

MapCoverage map_coverage(std::span<const IndividualPtr> population,
                         const ExperimentSettings& settings);

}  // namespace cambrian
