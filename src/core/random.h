#pragma once

// Random streams: xoshiro256** (Blackman & Vigna 2018) seeded through SplitMix64. No stream is ever
// shared: whoever needs chance derives one from what it is for, so threads and the number of draws
// elsewhere cannot change a result. Distributions are our own; the standard ones may differ between
// libraries.

#include "core/assert.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>

namespace cambrian {

// What a stream is used for; the values are part of every result and never change.
enum class Purpose : std::uint64_t {
    kFounder = 1,
    kSelection = 2,
    kBreeding = 3,
    kMutation = 4,
    kTrial = 5,
    kDisplay = 6,
    kPicking = 7,
    kTest = 99,
};

// One seed from several keys, order mattering.
std::uint64_t stream_seed(std::initializer_list<std::uint64_t> keys);

// The usual derivation: (experiment seed, generation, child index, purpose).
std::uint64_t stream_seed(std::uint64_t experiment_seed, std::uint64_t generation,
                          std::uint64_t child, Purpose purpose);

class RandomStream {
public:
    explicit RandomStream(std::uint64_t seed);

    std::uint64_t bits();                     // 64 uniform bits
    double uniform();                         // [0, 1), 53 bits
    double uniform(double low, double high);  // [low, high)
    std::size_t below(std::size_t count);     // 0 .. count-1, unbiased; count > 0
    int between(int low, int high);           // low .. high inclusive
    bool chance(double probability);          // one draw, whatever the probability
    // Mean 0, variance 1, bounded by +-3.47: a scaled sum of four uniforms (core/README.md 1).
    double gauss();
    // Index with probability proportional to its weight; negative weights count as 0. All zero or
    // empty of positive weights: uniform. weights must not be empty.
    std::size_t weighted(std::span<const double> weights);

    template <class Sequence>
    auto& pick(Sequence& items) {
        return items[below(items.size())];
    }
    template <class T>
    void shuffle(std::span<T> items) {
        for (std::size_t left = items.size(); left > 1; --left) {
            std::swap(items[left - 1], items[below(left)]);
        }
    }

private:
    std::array<std::uint64_t, 4> state_;
};

}  // namespace cambrian
