#pragma once

#include "core/result.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr std::int64_t kMostSeed = 1'000'000'000'000'000;
inline constexpr std::size_t kMostSeeds = 100;

// Parses "7", "1..9" or several of these separated by commas. Returns them in ascending order
// without repetitions.
Result<std::vector<std::uint64_t>> parse_seeds(std::string_view text);

}  // namespace cambrian
