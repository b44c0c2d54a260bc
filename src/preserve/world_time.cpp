#include "preserve/world_time.h"

#include <fmt/core.h>

namespace cambrian {

std::string world_time(std::uint64_t tick) {
    const std::uint64_t seconds = tick / 60;
    if (seconds < 3600) return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
    return fmt::format("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

}  // namespace cambrian
