#pragma once

#include <cstdint>

namespace cambrian {

// How far the generation in flight is.
struct ProgressView {
    std::uint32_t done = 0;
    std::uint32_t total = 0;
    double per_second = 0.0;    // creatures evaluated; 0 if unknown
    double seconds_left = 0.0;  // of the generation; negative if unknown
};

}  // namespace cambrian
