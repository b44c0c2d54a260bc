#pragma once

#include <cstdint>
#include <string>

namespace cambrian {

// Returns a preserve's time as "2:05" or "1:02:05".
std::string world_time(std::uint64_t tick);

}  // namespace cambrian
