#pragma once

// Four doubles worked on at once. Sums over lanes have a fixed order, so that the bits do not
// depend on the processor's vector width.

#include <cstring>

namespace cambrian {

inline constexpr int kLanes = 4;
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));

inline constexpr int round_up_to_lanes(int count) {
    return (count + kLanes - 1) / kLanes * kLanes;
}

// Sum of products; count is a multiple of kLanes.
inline double lane_product(const double* first, const double* second, int count) {
    Lanes sum = {};
    for (int i = 0; i < count; i += kLanes) {
        Lanes a;
        Lanes b;
        std::memcpy(&a, first + i, sizeof(a));
        std::memcpy(&b, second + i, sizeof(b));
        sum += a * b;
    }
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

}  // namespace cambrian
