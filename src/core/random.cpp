#include "core/random.h"

#include <bit>
#include <cmath>
#include <numbers>

namespace cambrian {
namespace {

std::uint64_t split_mix(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15ULL;
    std::uint64_t mixed = state;
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9ULL;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebULL;
    return mixed ^ (mixed >> 31);
}

}  // namespace

std::uint64_t stream_seed(std::initializer_list<std::uint64_t> keys) {
    std::uint64_t seed = 0x243f6a8885a308d3ULL;
    for (const std::uint64_t key : keys) {
        std::uint64_t mixed = seed ^ key;
        seed = split_mix(mixed) + std::rotl(seed, 23);
    }
    return seed;
}

std::uint64_t stream_seed(std::uint64_t experiment_seed, std::uint64_t generation,
                          std::uint64_t child, Purpose purpose) {
    return stream_seed({experiment_seed, generation, child, static_cast<std::uint64_t>(purpose)});
}

RandomStream::RandomStream(std::uint64_t seed) : state_{} {
    for (std::uint64_t& word : state_)
        word = split_mix(seed);
}

std::uint64_t RandomStream::bits() {
    const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
    const std::uint64_t shifted = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= shifted;
    state_[3] = std::rotl(state_[3], 45);
    return result;
}

double RandomStream::uniform() {
    return static_cast<double>(bits() >> 11) * 0x1p-53;
}

double RandomStream::uniform(double low, double high) {
    const double value = low + (high - low) * uniform();
    return value < high ? value : std::nextafter(high, low);  // the sum may have been rounded up
}

std::size_t RandomStream::below(std::size_t count) {
    CAMBRIAN_ASSERT(count > 0, "a choice among none");
    const std::uint64_t range = count;
    const std::uint64_t rejected_below = (0 - range) % range;  // 2^64 mod range
    std::uint64_t draw = bits();
    while (draw < rejected_below)
        draw = bits();
    return draw % range;
}

int RandomStream::between(int low, int high) {
    CAMBRIAN_ASSERT(low <= high, "an empty range of integers");
    const auto span = static_cast<std::size_t>(static_cast<std::int64_t>(high) - low) + 1;
    return static_cast<int>(low + static_cast<std::int64_t>(below(span)));
}

bool RandomStream::chance(double probability) {
    return uniform() < probability;
}

double RandomStream::gauss() {
    double sum = uniform();  // one per statement, since compilers evaluate operands in any order
    for (int i = 0; i < 3; ++i)
        sum += uniform();
    return std::numbers::sqrt3 * (sum - 2.0);
}

std::size_t RandomStream::weighted(std::span<const double> weights) {
    CAMBRIAN_ASSERT(!weights.empty(), "a choice among none");
    double total = 0.0;
    for (const double weight : weights)
        total += weight > 0.0 ? weight : 0.0;
    if (!(total > 0.0)) return below(weights.size());
    double mark = uniform() * total;
    std::size_t last_positive = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        if (!(weights[i] > 0.0)) continue;
        last_positive = i;
        if (mark < weights[i]) return i;
        mark -= weights[i];
    }
    return last_positive;
}

}  // namespace cambrian
