#pragma once

// The bright places of a preserve, as its settings name them.

#include "core/result.h"
#include "evolution/settings/world_area.h"
#include "math/types.h"

#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kMostPatches = 64;
inline constexpr double kLeastSpread = 0.1;  // m
inline constexpr double kMostSpread = 500.0;

// Plants grow around its middle with this standard deviation along x and, without ground, along y.
struct LightPatch {
    Vec3 center = Vec3::Zero();  // m
    double spread = 1.0;         // m
};

// Reads "x y spread; x y spread", in m. An empty text has none.
Result<std::vector<LightPatch>> patches_of(std::string_view text);

// Fails if the spread is out of its range, or the middle is not within the world.
Status check_patch(const LightPatch& patch, const WorldArea& area);

}  // namespace cambrian
