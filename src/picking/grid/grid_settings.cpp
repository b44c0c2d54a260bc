#include "picking/grid/grid_settings.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

namespace cambrian {

Status check_grid(const GridSettings& grid) {
    if (std::find(kGridSizes.begin(), kGridSizes.end(), grid.cells) == kGridSizes.end()) {
        return Error{fmt::format("a grid has 4, 6, 9, 12, 16 or 25 creatures, not {}", grid.cells)};
    }
    if (!(grid.fitness_weight >= 0.0 && grid.fitness_weight <= 1.0))
        return Error{"the weight of fitness in a grid is from 0 to 1"};
    return {};
}

int extra_mutations(Boldness boldness) {
    switch (boldness) {
        case Boldness::kGentle:
            return 0;
        case Boldness::kBold:
            return 1;
        case Boldness::kWild:
            return 3;
    }
    return 0;
}

int immigrant_cells(const GridSettings& grid) {
    // Rounded to the nearest integer.
    return grid.boldness == Boldness::kWild ? (grid.cells + 3) / 6 : 0;
}

}  // namespace cambrian
