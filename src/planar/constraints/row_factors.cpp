#include "core/assert.h"
#include "dynamics/simd.h"
#include "planar/constraints/complementarity_solver.h"

#include <algorithm>

namespace cambrian {
namespace {

template <int kFixed>
constexpr std::size_t kRoom = kFixed > 0 ? kFixed : kMaxEquations / kLanes + 1;  // blocks

template <int kFixed, class Number = double>
struct Lines {
    int count;
    int blocks_at_run_time;
    Number* first;

    CAMBRIAN_INLINE int blocks() const { return block_count<kFixed>(blocks_at_run_time); }
    CAMBRIAN_INLINE int stride() const { return blocks() * kLanes; }
    CAMBRIAN_INLINE Number* operator[](int equation) const {
        return first + std::ptrdiff_t{equation} * stride();
    }
};

// Eliminates a pivot's column from the lines below; blocks before `first` are finished.
template <int kFixed>
CAMBRIAN_INLINE bool eliminate_column(const Lines<kFixed>& lines, int pivot, double least,
                                      int first_block) {
    double* pivot_line = lines[pivot];
    if (!(pivot_line[pivot] > least)) return false;
    const double inverse = 1.0 / pivot_line[pivot];
    Simd4d pivots[kRoom<kFixed>];
    for (int b = first_block; b < lines.blocks(); ++b)
        pivots[b] = load_lanes(pivot_line + b * kLanes);
    double* end = lines[lines.count];
    for (double* line = lines[pivot + 1]; line != end; line += lines.stride()) {
        const double factor = -inverse * line[pivot];
        for (int b = first_block; b < lines.blocks(); ++b)
            store_lanes(line + b * kLanes, load_lanes(line + b * kLanes) + factor * pivots[b]);
        line[pivot] = factor;
    }
    pivot_line[pivot] = inverse;
    return true;
}

// Eliminates all columns of the blocks from kBlock on.
template <int kBlock, int kFixed>
CAMBRIAN_INLINE int eliminate_from(const Lines<kFixed>& lines, const double* least) {
    if constexpr (kBlock < kFixed) {
        constexpr int last = (kBlock + 1) * kLanes - 1;
        for (int pivot = kBlock * kLanes; pivot < std::min(lines.count, last); ++pivot) {
            if (!eliminate_column(lines, pivot, least[pivot], kBlock)) return pivot;
        }
        if (lines.count <= last) return lines.count;
        if (!eliminate_column(lines, last, least[last], kBlock + 1)) return last;
        return eliminate_from<kBlock + 1>(lines, least);
    }
    return lines.count;
}

// Returns the equation whose pivot fails, or the count.
template <int kFixed>
[[gnu::noinline]] int eliminate(const Lines<kFixed>& lines, const double* least) {
    if constexpr (kFixed > 0) {
        return eliminate_from<0>(lines, least);
    } else {
        for (int pivot = 0; pivot < lines.count; ++pivot) {
            if (!eliminate_column(lines, pivot, least[pivot], (pivot + 1) / kLanes)) return pivot;
        }
        return lines.count;
    }
}

void clear(int slots, double* vector) {
    for (int i = 0; i < slots; i += kLanes)
        store_lanes(vector + i, Simd4d{});
}

// Solves the equations of the blocks up to kBlock; the solution of those above is known. A block is
// kept in a register, because a vector is not loaded quickly soon after one of its lanes is stored.
template <int kBlock, int kFixed>
CAMBRIAN_INLINE void substitute_to(const Lines<kFixed, const double>& lines, double* solution) {
    if constexpr (kBlock >= 0) {
        const int first = kBlock * kLanes;
        Simd4d block = {};
        for (int lane = kLanes - 1; lane >= 0; --lane) {
            const int i = first + lane;
            if (i >= lines.count) continue;
            const double* line = lines[i];
            Simd4d known = load_lanes(line + first) * block;
            for (int b = kBlock + 1; b < kFixed; ++b)
                known += load_lanes(line + b * kLanes) * load_lanes(solution + b * kLanes);
            block[lane] = (line[lines.count] - sum_of(known)) * line[i];
        }
        store_lanes(solution + first, block);
        substitute_to<kBlock - 1>(lines, solution);
    }
}

template <int kFixed>
[[gnu::noinline]] void substitute_in(const Lines<kFixed, const double>& lines, double* solution) {
    if constexpr (kFixed > 0) {
        substitute_to<kFixed - 1>(lines, solution);
    } else {
        clear(lines.stride(), solution);
        for (int i = lines.count - 1; i >= 0; --i) {
            const double* line = lines[i];
            const int first = i / kLanes * kLanes;
            const double known =
                lane_product(line + first, solution + first, lines.stride() - first);
            solution[i] = (line[lines.count] - known) * line[i];
        }
    }
}

// Returns the sums of a and of b.
CAMBRIAN_INLINE Simd2d sums_of(const Simd4d& a, const Simd4d& b) {
    const Simd4d sums = pair_sums(a, b);
    return __builtin_shufflevector(sums, sums, 0, 1) + __builtin_shufflevector(sums, sums, 2, 3);
}

// Returns the products of a line, between two blocks, with both vectors.
CAMBRIAN_INLINE Simd2d products(const double* line, int first_block, int end_block,
                                const PerEquation (&vectors)[2]) {
    Simd4d sums[2] = {};
    for (int b = first_block; b < end_block; ++b) {
        const Simd4d block = load_lanes(line + b * kLanes);
        sums[0] += block * load_lanes(vectors[0] + b * kLanes);
        sums[1] += block * load_lanes(vectors[1] + b * kLanes);
    }
    return sums_of(sums[0], sums[1]);
}

}  // namespace

bool RowFactors::factorize(const PerEquation& least_pivots) {
    lost_ = with_fixed_blocks(stride_ / kLanes, [&](auto fixed) {
        return eliminate<fixed()>(Lines<fixed()>{count_, stride_ / kLanes, lines_}, least_pivots);
    });
    return lost_ == count_;
}

void RowFactors::substitute(PerEquation& solution) const {
    CAMBRIAN_TICK_ASSERT(lost_ == count_, "the factors are complete");
    with_fixed_blocks(stride_ / kLanes, [&](auto fixed) {
        substitute_in(Lines<fixed(), const double>{count_, stride_ / kLanes, lines_}, solution);
    });
}

void RowFactors::solve(const PerEquation (&sides)[2], PerEquation (&solutions)[2]) const {
    CAMBRIAN_TICK_ASSERT(lost_ == count_, "the factors are complete");
    PerEquation forward[2];
    for (int s = 0; s < 2; ++s) {
        clear(stride_, forward[s]);
        clear(stride_, solutions[s]);
    }
    for (int i = 0; i < count_; ++i) {
        const Simd2d known = products(line(i), 0, i / kLanes + 1, forward);
        for (int s = 0; s < 2; ++s)
            forward[s][i] = sides[s][i] + known[s];
    }
    for (int i = count_ - 1; i >= 0; --i) {
        const Simd2d known = products(line(i), i / kLanes, stride_ / kLanes, solutions);
        for (int s = 0; s < 2; ++s)
            solutions[s][i] = (forward[s][i] - known[s]) * line(i)[i];
    }
}

}  // namespace cambrian
