#pragma once

#include <cstdint>

namespace cambrian {

// The progress of the generation that is being evaluated.
struct ProgressView {
    std::uint32_t done = 0;
    std::uint32_t total = 0;
    double per_second = 0.0;    // creatures evaluated per second; 0 if unknown
    double seconds_left = 0.0;  // s to the end of the generation; negative if unknown
};

}  // namespace cambrian
