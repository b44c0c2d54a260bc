#pragma once

// Vectors of four doubles (four bodies, parts or coordinates) and of two (a planar vector). They
// use only the four exactly rounded operations and fixed orders of summation, so the bits do not
// depend on the vector width of the processor (planar/README.md 19).

#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

// Marks functions with vectors as arguments or results. They are always inlined, because the
// calling convention of vectors depends on the processor's instructions.
#define CAMBRIAN_INLINE inline __attribute__((always_inline))

namespace cambrian {

inline constexpr int kLanes = 4;
using Simd4d = double __attribute__((vector_size(kLanes * sizeof(double))));
using Simd4i = std::int64_t __attribute__((vector_size(kLanes * sizeof(std::int64_t))));
using Simd2d = double __attribute__((vector_size(2 * sizeof(double))));

inline constexpr int round_up_to_lanes(int count) {
    return (count + kLanes - 1) & -kLanes;
}

// Four doubles in memory. Unlike copied bytes they overlap no integers, so that the compiler keeps
// counts and indices in registers.
using StoredLanes __attribute__((vector_size(kLanes * sizeof(double)), aligned(alignof(double)))) =
    double;
static_assert(alignof(StoredLanes) == alignof(double), "vectors are stored anywhere");

CAMBRIAN_INLINE Simd4d load_lanes(const double* from) {
    return *reinterpret_cast<const StoredLanes*>(from);
}
CAMBRIAN_INLINE void store_lanes(double* to, const Simd4d& lanes) {
    *reinterpret_cast<StoredLanes*>(to) = lanes;
}
CAMBRIAN_INLINE Simd4d all_lanes(double value) {
    return Simd4d{value, value, value, value};
}
// Returns the lanes with a value in one of them; unchanged if `lane` is none of the four. A vector
// in memory is not loaded quickly soon after a scalar is stored into it.
CAMBRIAN_INLINE Simd4d with_lane(const Simd4d& lanes, std::int64_t lane, double value) {
    return (Simd4i{0, 1, 2, 3} == lane) ? all_lanes(value) : lanes;
}
CAMBRIAN_INLINE Simd4d gather(const double* from, const int* index) {
    return Simd4d{from[index[0]], from[index[1]], from[index[2]], from[index[3]]};
}
// Returns the sums of neighbouring lanes (a0 + a1, b0 + b1, a2 + a3, b2 + b3).
CAMBRIAN_INLINE Simd4d pair_sums(const Simd4d& a, const Simd4d& b) {
#ifdef __AVX__
    return __builtin_ia32_haddpd256(a, b);
#else
    return __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
#endif
}
CAMBRIAN_INLINE double sum_of(const Simd4d& lanes) {
    const Simd4d sums = pair_sums(lanes, lanes);
    return sums[0] + sums[2];
}
// Transposes the 4 x 4 matrix with these rows.
CAMBRIAN_INLINE void transpose(Simd4d& a, Simd4d& b, Simd4d& c, Simd4d& d) {
    const Simd4d even_ab = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const Simd4d odd_ab = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Simd4d even_cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const Simd4d odd_cd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    a = __builtin_shufflevector(even_ab, even_cd, 0, 1, 4, 5);
    b = __builtin_shufflevector(odd_ab, odd_cd, 0, 1, 4, 5);
    c = __builtin_shufflevector(even_ab, even_cd, 2, 3, 6, 7);
    d = __builtin_shufflevector(odd_ab, odd_cd, 2, 3, 6, 7);
}
// Returns the bits that the mask has.
CAMBRIAN_INLINE Simd4d masked(const Simd4d& lanes, const Simd4i& mask) {
    Simd4i bits;
    std::memcpy(&bits, &lanes, sizeof(bits));
    bits &= mask;
    Simd4d result;
    std::memcpy(&result, &bits, sizeof(result));
    return result;
}
CAMBRIAN_INLINE Simd4d magnitude(const Simd4d& lanes) {
    return masked(lanes, Simd4i{INT64_MAX, INT64_MAX, INT64_MAX, INT64_MAX});
}
inline double magnitude(double value) {
    return std::fabs(value);
}
CAMBRIAN_INLINE Simd4d lesser(const Simd4d& a, const Simd4d& b) {
    return a < b ? a : b;
}
CAMBRIAN_INLINE Simd4d greater(const Simd4d& a, const Simd4d& b) {
    return a > b ? a : b;
}
// Clamps value to [-size, size].
CAMBRIAN_INLINE Simd4d clamp_size(const Simd4d& value, const Simd4d& size) {
    return greater(lesser(value, size), -size);
}
CAMBRIAN_INLINE double largest_of(const Simd4d& lanes) {
    const double low = lanes[0] > lanes[1] ? lanes[0] : lanes[1];
    const double high = lanes[2] > lanes[3] ? lanes[2] : lanes[3];
    return low > high ? low : high;
}

// Returns the lanes in which a comparison is true, as bits.
CAMBRIAN_INLINE unsigned true_lanes(const Simd4i& comparison) {
#ifdef __AVX__
    Simd4d signs;
    std::memcpy(&signs, &comparison, sizeof(signs));
    return static_cast<unsigned>(__builtin_ia32_movmskpd256(signs));
#else
    unsigned lanes = 0;
    for (int lane = 0; lane < kLanes; ++lane)
        lanes |= comparison[lane] != 0 ? 1U << lane : 0U;
    return lanes;
#endif
}

// The dot product of two arrays; count is a multiple of kLanes.
CAMBRIAN_INLINE double lane_product(const double* first, const double* second, int count) {
    Simd4d sum = {};
    for (int i = 0; i < count; i += kLanes)
        sum += load_lanes(first + i) * load_lanes(second + i);
    return sum_of(sum);
}

// The components of four planar vectors.
struct Simd4dVector {
    Simd4d x, y;
};

// Turns four vectors by angles with this cosine and sine.
CAMBRIAN_INLINE Simd4dVector turned(const Simd4dVector& vector, const Simd4d& cosine,
                                    const Simd4d& sine) {
    return {cosine * vector.x - sine * vector.y, sine * vector.x + cosine * vector.y};
}

// Adds to four sums of weighted vectors those of the next four.
CAMBRIAN_INLINE void add_weighted(const double* weights, const Simd4d& x, const Simd4d& y,
                                  Simd4dVector& sums) {
    const Simd4d weight = load_lanes(weights);
    sums.x += weight * x;
    sums.y += weight * y;
}
// Returns sums of weighted vectors, of every fourth from each of the first four on; count is a
// multiple of kLanes.
CAMBRIAN_INLINE Simd4dVector weighted_sums(const double* weights, const double* x, const double* y,
                                           int count) {
    Simd4dVector sums = {};
    for (int i = 0; i < count; i += kLanes)
        add_weighted(weights + i, load_lanes(x + i), load_lanes(y + i), sums);
    return sums;
}

CAMBRIAN_INLINE Simd2d both(double value) {
    return Simd2d{value, value};
}
CAMBRIAN_INLINE double dot(const Simd2d& a, const Simd2d& b) {
    const Simd2d product = a * b;
    return product[0] + product[1];
}

// Unrolls loops over the blocks of kLanes columns of a matrix: a small number of blocks becomes a
// constant of the compiler.

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
