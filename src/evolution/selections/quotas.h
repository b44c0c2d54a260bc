#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

// Divides `total` into integers in proportion to the shares, by largest remainder. Equal remainders
// favour the earlier share. Shares must not be negative and not all 0.
std::vector<std::size_t> largest_remainder(std::span<const double> shares, std::size_t total);

}  // namespace cambrian
