#pragma once

// Ground drawn by hand: a stroke replaces the profile between its ends.

#include "core/result.h"
#include "world/terrain.h"

#include <span>
#include <string>

namespace cambrian {

inline constexpr double kGroundSnap = 0.05;     // m, to which points of strokes snap
inline constexpr double kShortestStroke = 0.1;  // m, from end to end
inline constexpr double kGroundKept = 40.0;     // m to both sides, of ground that was not drawn

// Returns the points of a stroke as it becomes ground: from left to right, snapped, without those
// that hardly matter. Empty if the stroke is too short. A straight one keeps only its ends.
std::vector<GroundPoint> snapped_stroke(std::span<const GroundPoint> stroke, bool straight);

// Returns `settings` as drawn ground with the profile between the ends of a snapped stroke replaced
// by it. Fails if that makes no ground.
Result<TerrainSettings> with_stroke(const TerrainSettings& settings,
                                    std::span<const GroundPoint> stroke);

}  // namespace cambrian
