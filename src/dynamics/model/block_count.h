#pragma once

// Unrolls loops over the blocks of kLanes columns of a matrix: a small number of blocks becomes a
// constant of the compiler.

#include "dynamics/model/simd.h"

#include <type_traits>

namespace cambrian {

inline constexpr int kMaxFixedBlocks = 8;

// kFixed: the number of blocks, or 0 if it is known at run time only.
template <int kFixed>
CAMBRIAN_INLINE int block_count(int blocks) {
    return kFixed > 0 ? kFixed : blocks;
}

// Calls work with the number of blocks as an integral_constant, or with 0 for many blocks.
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
