#pragma once

// How the next grid is to be bred from the picks (picking/README.md 1).

#include "core/result.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cambrian {

inline constexpr std::array kGridSizes = {4, 6, 9, 12, 16, 25};  // cells
inline constexpr std::size_t kMostPicks = 4;

// How many mutations a child gets: as breeding/README.md 1 draws, one more, or three more and a few
// random creatures besides.
enum class Boldness : std::uint8_t { kGentle, kBold, kWild };

struct GridSettings {
    int cells = 12;  // one of kGridSizes
    Boldness boldness = Boldness::kGentle;
    // The dial from "all me" (0: the children shown differ as much as possible) to "all fitness"
    // (1: they are the fittest).
    double fitness_weight = 0.0;

    friend bool operator==(const GridSettings&, const GridSettings&) = default;
};

Status check_grid(const GridSettings& grid);

int extra_mutations(Boldness boldness);  // a child, besides those the settings draw
// Cells for fresh random creatures: 2 of 12 where wild, in proportion in other grids.
int newcomer_cells(const GridSettings& grid);

}  // namespace cambrian
