#pragma once

#include <cstdint>

namespace cambrian {

// Returns an id different from that of any other process, not reproducible.
std::uint64_t random_id();

}  // namespace cambrian
