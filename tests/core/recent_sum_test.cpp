#include "core/recent_sum.h"

#include "support/catch.h"

using namespace cambrian;

TEST_CASE("RecentSum forgets what is older than a minute", "[core]") {
    RecentSum sum;
    sum.add(2.0, 0.2);
    sum.add(3.0, 10.7);
    CHECK(sum.sum(10.9) == 5.0);
    CHECK(sum.sum(59.9) == 5.0);
    CHECK(sum.sum(60.0) == 3.0);
    CHECK(sum.sum(70.9) == 0.0);
    sum.add(1.0, 70.9);  // replaces the same second of the minute before
    CHECK(sum.sum(70.9) == 1.0);
    CHECK(sum.sum(1e6) == 0.0);
}

TEST_CASE("RecentSum gives the rate of steady work from its first second on", "[core]") {
    RecentSum sum;
    CHECK(sum.rate(4.0, 5) == 0.0);
    const auto work = [&sum](double from, double to) {
        for (double now = from; now < to; now += 0.01)
            sum.add(1.0, now);
    };
    work(7.5, 9.5);
    CHECK(sum.rate(9.5, 5) == Approx(100.0).epsilon(0.02));
    work(9.5, 200.25);
    CHECK(sum.rate(200.25, 5) == Approx(100.0).epsilon(0.02));
    CHECK(sum.rate(200.25, RecentSum::kSeconds) == Approx(100.0).epsilon(0.02));
    CHECK(sum.rate(205.25, 5) == Approx(0.0));
}

TEST_CASE("RecentSum survives a clock that runs back", "[core]") {
    RecentSum sum;
    for (const double now : {100.0, 30.0, -0.5, -61.0, 1.0}) {
        sum.add(1.0, now);
        CHECK(sum.sum(now, 1) == 1.0);
        CHECK(sum.rate(now, 5) >= 0.0);
    }
    CHECK(sum.sum(100.9) <= 5.0);
}
