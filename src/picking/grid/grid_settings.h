#pragma once

// The options with which the next grid is bred from the picks (picking/README.md 1).

#include "core/result.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cambrian {

inline constexpr std::array kGridSizes = {4, 6, 9, 12, 16, 25};  // cells
inline constexpr std::size_t kMostPicks = 4;

// The number of mutations per child: the number drawn as in breeding/README.md 1, one more, or
// three more and some random creatures besides.
enum class Boldness : std::uint8_t { kGentle, kBold, kWild };

struct GridSettings {
    int cells = 12;  // one of kGridSizes
    Boldness boldness = Boldness::kGentle;
    // Weight of fitness in the choice of children. At 0 the children differ as much as possible; at
    // 1 they are the fittest.
    double fitness_weight = 0.0;

    friend bool operator==(const GridSettings&, const GridSettings&) = default;
};

Status check_grid(const GridSettings& grid);

// Returns mutations per child, in addition to those that the settings draw.
int extra_mutations(Boldness boldness);
// Returns the number of cells for new random creatures: 2 of 12 if wild, in proportion for other
// sizes.
int immigrant_cells(const GridSettings& grid);

}  // namespace cambrian
