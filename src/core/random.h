#pragma once

// Random streams: xoshiro256** (Blackman & Vigna 2018) seeded with SplitMix64. Streams are never
// shared: each purpose derives its own, so threads and other draws cannot change a result.
// Distributions are our own, since the standard ones may differ between libraries.

#include "core/assert.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>

namespace cambrian {

// The purpose of a stream. The values are part of every result and never change.
enum class Purpose : std::uint64_t {
    kFounder = 1,
    kSelection = 2,
    kBreeding = 3,
    kMutation = 4,
    kTrial = 5,
    kPicking = 7,  // 6 was used once
    kLight = 8,
    kPreserve = 9,
    kOpponent = 10,
    kMuseum = 11,
    kTest = 99,
};

// Returns a seed that depends on all keys and on their order.
std::uint64_t stream_seed(std::initializer_list<std::uint64_t> keys);

// Returns the seed for (experiment seed, generation, child index, purpose).
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
    bool chance(double probability);          // one draw for any probability
    // Returns a variate with mean 0 and variance 1 within +-3.47: a scaled sum of four uniforms
    // (core/README.md 1).
    double gauss();
    // Returns an index with probability proportional to its weight. Negative weights count as 0. If
    // no weight is positive, all are equal. `weights` must not be empty.
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
