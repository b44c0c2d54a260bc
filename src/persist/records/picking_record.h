#pragma once

// The part of selection by hand that an experiment file keeps: all grids and the present one.

#include "picking/picking_snapshot.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

struct PickingRecord {
    PickingTree tree;
    std::vector<std::size_t> picks;  // cells of the displayed grid
    std::vector<JudgedIndividual> shelf;
};

// Names in the tables, in the order of the enumerations.
inline constexpr std::array<std::string_view, 6> kOriginNames = {
    "population", "creatures", "breeding", "newcomers", "assistance", "shelf"};
inline constexpr std::array<std::string_view, 3> kBoldnessNames = {"gentle", "bold", "wild"};

// Cells in order of picking, as in "0 3 7".
std::string picks_text(std::span<const std::size_t> picks);
std::optional<std::vector<std::size_t>> parse_picks(std::string_view text);

}  // namespace cambrian
