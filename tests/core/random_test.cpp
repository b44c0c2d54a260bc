#include "core/random.h"

#include "support/catch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <vector>

using namespace cambrian;

namespace {

constexpr int kDraws = 200000;

struct Moments {
    double mean = 0.0;
    double variance = 0.0;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
};

template <class Draw>
Moments moments_of(Draw draw) {
    Moments moments;
    double sum_of_squares = 0.0;
    for (int i = 0; i < kDraws; ++i) {
        const double value = draw();
        moments.mean += value / kDraws;
        sum_of_squares += value * value / kDraws;
        moments.lowest = std::min(moments.lowest, value);
        moments.highest = std::max(moments.highest, value);
    }
    moments.variance = sum_of_squares - moments.mean * moments.mean;
    return moments;
}

// The authors' reference algorithm, implemented independently.
std::uint64_t reference_split_mix(std::uint64_t& x) {
    std::uint64_t z = (x += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

}  // namespace

TEST_CASE("uniform numbers fill the range from 0 to 1 evenly", "[core][random]") {
    RandomStream stream(1);
    const Moments moments = moments_of([&] { return stream.uniform(); });
    CHECK(moments.mean == Approx(0.5).margin(0.003));
    CHECK(moments.variance == Approx(1.0 / 12).margin(0.001));
    CHECK(moments.lowest >= 0.0);
    CHECK(moments.highest < 1.0);
}

TEST_CASE("gauss has mean 0, variance 1 and stays within 3.47", "[core][random]") {
    RandomStream stream(2);
    const Moments moments = moments_of([&] { return stream.gauss(); });
    CHECK(moments.mean == Approx(0.0).margin(0.01));
    CHECK(moments.variance == Approx(1.0).margin(0.02));
    CHECK(moments.lowest > -3.47);
    CHECK(moments.highest < 3.47);
}

TEST_CASE("a uniform number never reaches the range's upper end", "[core][random]") {
    RandomStream stream(3);
    // Only two doubles are in this range, one of them its upper end.
    const double low = 1e16;
    const double high = std::nextafter(low, 2e16);
    for (int i = 0; i < 1000; ++i)
        REQUIRE(stream.uniform(low, high) == low);
    CHECK(stream.uniform(2.0, 2.0) == 2.0);
}

TEST_CASE("choices among n are even for any n", "[core][random]") {
    RandomStream stream(4);
    for (const std::size_t count : {1U, 2U, 3U, 7U, 10U}) {
        std::vector<int> hits(count);
        for (int i = 0; i < kDraws; ++i)
            ++hits[stream.below(count)];
        const double expected = static_cast<double>(kDraws) / static_cast<double>(count);
        for (const int hit : hits)
            REQUIRE(std::fabs(hit - expected) < 6 * std::sqrt(expected));
    }
}

TEST_CASE("a choice among 2^63 + 1 is as often above the middle as below", "[core][random]") {
    // The remainder alone would give the lower half twice as often.
    RandomStream stream(5);
    const std::size_t count = (std::size_t{1} << 63) + 1;
    int upper = 0;
    for (int i = 0; i < 10000; ++i)
        upper += stream.below(count) > count / 2 ? 1 : 0;
    CHECK(upper == Approx(5000).margin(250));
}

TEST_CASE("integers between two ends reach both and no more", "[core][random]") {
    RandomStream stream(6);
    std::set<int> seen;
    for (int i = 0; i < 1000; ++i)
        seen.insert(stream.between(-2, 2));
    CHECK(seen == std::set<int>{-2, -1, 0, 1, 2});
    CHECK(stream.between(5, 5) == 5);
    const int any =
        stream.between(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
    CHECK(any != stream.between(std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

TEST_CASE("a chance costs one draw whatever its probability", "[core][random]") {
    RandomStream certain(7);
    RandomStream impossible(7);
    CHECK(certain.chance(1.0));
    CHECK_FALSE(impossible.chance(0.0));
    CHECK(certain.bits() == impossible.bits());
}

TEST_CASE("weighted choices follow their weights", "[core][random]") {
    RandomStream stream(8);
    const std::array<double, 4> weights = {1.0, 0.0, 3.0, -5.0};
    std::array<int, 4> hits{};
    for (int i = 0; i < kDraws; ++i)
        ++hits[stream.weighted(weights)];
    CHECK(hits[0] == Approx(kDraws * 0.25).epsilon(0.03));
    CHECK(hits[2] == Approx(kDraws * 0.75).epsilon(0.03));
    CHECK(hits[1] + hits[3] == 0);
}

TEST_CASE("without a positive weight the choice is even", "[core][random]") {
    RandomStream stream(9);
    const std::array<double, 3> weights = {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()};
    std::array<int, 3> hits{};
    for (int i = 0; i < 30000; ++i)
        ++hits[stream.weighted(weights)];
    for (const int hit : hits)
        CHECK(hit == Approx(10000).margin(500));
}

TEST_CASE("every order of three is equally likely to come out of a shuffle", "[core][random]") {
    RandomStream stream(10);
    std::array<int, 27> hits{};
    for (int i = 0; i < 60000; ++i) {
        std::array<int, 3> items = {0, 1, 2};
        stream.shuffle(std::span<int>(items));
        ++hits[static_cast<std::size_t>(items[0] * 9 + items[1] * 3 + items[2])];
    }
    const auto orders = std::count_if(hits.begin(), hits.end(), [](int hit) { return hit > 0; });
    CHECK(orders == 6);
    for (const int hit : hits)
        CHECK((hit == 0 || std::fabs(hit - 10000.0) < 600.0));
}

TEST_CASE("neighbouring keys give unrelated seeds", "[core][random]") {
    // Avalanche: changing one bit of one key flips half of the seed's bits.
    double flipped = 0.0;
    for (std::uint64_t key = 0; key < 1000; ++key) {
        const std::uint64_t seed = stream_seed({1, key, 3});
        flipped += std::popcount(seed ^ stream_seed({1, key ^ (1ULL << (key % 64)), 3}));
    }
    CHECK(flipped / 1000 == Approx(32.0).margin(1.0));
}

TEST_CASE("the order, number and purpose of keys all matter", "[core][random]") {
    const std::set<std::uint64_t> seeds = {stream_seed({}),
                                           stream_seed({0}),
                                           stream_seed({0, 0}),
                                           stream_seed({1, 2}),
                                           stream_seed({2, 1}),
                                           stream_seed(1, 2, 3, Purpose::kBreeding),
                                           stream_seed(1, 2, 3, Purpose::kMutation)};
    CHECK(seeds.size() == 7);
    CHECK(stream_seed(1, 2, 3, Purpose::kMutation) == stream_seed({1, 2, 3, 4}));
}

TEST_CASE("the streams of an experiment never overlap", "[core][random]") {
    std::vector<std::uint64_t> firsts;
    for (std::uint64_t generation = 0; generation < 100; ++generation) {
        for (std::uint64_t child = 0; child < 1000; ++child) {
            firsts.push_back(
                RandomStream(stream_seed(1, generation, child, Purpose::kFounder)).bits());
        }
    }
    std::sort(firsts.begin(), firsts.end());
    CHECK(std::adjacent_find(firsts.begin(), firsts.end()) == firsts.end());
}

TEST_CASE("the same seed gives the same numbers on every machine", "[core][random]") {
    // All evolution depends on these values; they never change.
    RandomStream stream(1);
    CHECK(stream.bits() == 0xb3f2af6d0fc710c5ULL);
    CHECK(stream.bits() == 0x853b559647364ceaULL);
    CHECK(stream.uniform() == 0x1.25f12eac10548p-1);
    CHECK(stream.gauss() == -0x1.34ff89310f524p+0);
    CHECK(stream.below(1000) == 429);
    CHECK(stream_seed(1, 2, 3, Purpose::kTrial) == 0x6b224ab12bcbb826ULL);
}

TEST_CASE("streams are xoshiro256** seeded by SplitMix64", "[core][random]") {
    std::uint64_t seed = 1234567;
    std::array<std::uint64_t, 4> s{};
    for (std::uint64_t& word : s)
        word = reference_split_mix(seed);
    REQUIRE(s[0] == 6457827717110365317ULL);  // published test vector of SplitMix64
    REQUIRE(s[1] == 3203168211198807973ULL);
    RandomStream stream(1234567);
    for (int i = 0; i < 1000; ++i) {
        REQUIRE(stream.bits() == std::rotl(s[1] * 5, 7) * 9);
        const std::uint64_t t = s[1] << 17;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= t;
        s[3] = std::rotl(s[3], 45);
    }
}
