#pragma once

// Loops over the blocks of kLanes columns of a matrix's lines are unrolled where there are few of
// them: their number is then a constant.

#include "dynamics/model/lanes.h"

#include <type_traits>

namespace cambrian {

inline constexpr int kMaxFixedBlocks = 8;

// kFixed is the number of blocks, or 0 where it is known at run time only.
template <int kFixed>
CAMBRIAN_INLINE int block_count(int blocks) {
    return kFixed > 0 ? kFixed : blocks;
}

// Calls work with the number of blocks as an integral_constant, or with 0 if there are many.
template <int kFixed = 1, class Work>
CAMBRIAN_INLINE decltype(auto) with_fixed_blocks(int blocks, const Work& work) {
    if constexpr (kFixed > kMaxFixedBlocks) {
        return work(std::integral_constant<int, 0>{});
    } else {
        if (blocks == kFixed) return work(std::integral_constant<int, kFixed>{});
        return with_fixed_blocks<kFixed + 1>(blocks, work);
    }
}

}  // namespace cambrian
