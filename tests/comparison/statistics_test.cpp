#include "comparison/statistics.h"

#include "core/sample_statistics.h"

#include <catch2/catch.hpp>

using namespace cambrian;

TEST_CASE("the median is the middle one, or between the middle two", "[comparison]") {
    CHECK(median({3.0, 1.0, 2.0}) == 2.0);
    CHECK(median({4.0, 1.0, 2.0, 3.0}) == 2.5);
}

TEST_CASE("the interval of the median lies within the values and around it", "[comparison]") {
    const std::vector<double> values = {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0};
    const Interval interval = median_interval(values);
    CHECK(interval.low == 3.0);  // P(median of 9 draws <= 2) is 2.5 %, <= 3 is 8.5 %
    CHECK(interval.high == 7.0);
    const Interval none = median_interval({2.0, 2.0, 2.0});
    CHECK(none.low == 2.0);
    CHECK(none.high == 2.0);
}

TEST_CASE("the U test counts the ways to split the ranks", "[comparison]") {
    const RankTest apart = mann_whitney({4.0, 5.0, 6.0}, {1.0, 2.0, 3.0});
    CHECK(apart.p == Approx(1.0 / 20));
    CHECK(apart.effect == 1.0);
    const RankTest reversed = mann_whitney({1.0, 2.0, 3.0}, {4.0, 5.0, 6.0});
    CHECK(reversed.p == Approx(1.0));
    CHECK(reversed.effect == 0.0);
    const RankTest mixed = mann_whitney({1.0, 4.0}, {2.0, 3.0});
    CHECK(mixed.p == Approx(4.0 / 6));  // rank sums of at least 5: 14, 23, 24, 34
    CHECK(mixed.effect == 0.5);
    const RankTest tied = mann_whitney({1.0, 1.0}, {1.0, 1.0});
    CHECK(tied.p == Approx(1.0));
    CHECK(tied.effect == 0.5);
    const RankTest nine =
        mann_whitney({11, 12, 13, 14, 15, 16, 17, 18, 19}, {1, 2, 3, 4, 5, 6, 7, 8, 9});
    CHECK(nine.p == Approx(1.0 / 48620));
}

TEST_CASE("the test of both sides is the same whichever comes first", "[comparison]") {
    const std::vector<double> low = {1.0, 2.0, 3.0};
    const std::vector<double> high = {4.0, 5.0, 6.0};
    CHECK(two_sided(low, high) == Approx(2.0 / 20));
    CHECK(two_sided(high, low) == Approx(2.0 / 20));
    CHECK(two_sided(low, low) == 1.0);
}
