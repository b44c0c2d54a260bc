#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

// Whole numbers that add up to `total` in proportion to the shares, by largest remainder; equal
// remainders go to the earlier share. Shares are not negative and not all 0.
std::vector<std::size_t> largest_remainder(std::span<const double> shares, std::size_t total);

}  // namespace cambrian
