#pragma once

// Ground of other programs, as the text of drawn points (world/terrain_settings.h).

#include "core/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr double kVoxelSize = 0.2;  // m; a robot of EvoGym's has 5 voxels

// What happens to voxels that move, or that lie above air.
enum class LooseVoxels : std::uint8_t { kRefused, kDropped };

// Reads a world of EvoGym (JSON): the tops of the columns of fixed voxels are the ground, and a
// column without one is a pit of 2 m. The start is above the third column, at height 0. Fails, with
// the object, for what ground cannot be.
Result<std::string> ground_of_voxels(std::string_view json, double voxel, LooseVoxels loose);

// Reads lines "x,y" in m. Fails with the number of a line that is anything else.
Result<std::string> ground_of_table(std::string_view csv);

}  // namespace cambrian
