#include "studio/plot.h"

#include "support/catch.h"

namespace cambrian {
namespace {

const PlotScale kScale{{100.0F, 50.0F, 400.0F, 200.0F}, 0.0, 20.0, -1.0, 3.0};

TEST_CASE("a plot's corners are its data's limits, with large values above", "[studio][plot]") {
    CHECK(kScale.x_at(0.0) == 100.0F);
    CHECK(kScale.x_at(20.0) == 500.0F);
    CHECK(kScale.y_at(3.0) == 50.0F);
    CHECK(kScale.y_at(-1.0) == 250.0F);
}

TEST_CASE("a position under the mouse reads back as the value drawn there", "[studio][plot]") {
    for (const double x : {0.0, 3.5, 20.0})
        CHECK(kScale.x_from(kScale.x_at(x)) == Approx(x).margin(1e-4));
}

TEST_CASE("marks stand at round values inside the range", "[studio][plot]") {
    CHECK(round_marks(0.0, 1.0, 5) ==
          std::vector<double>{0.0, 0.2, 0.4, 0.6000000000000001, 0.8, 1.0});
    CHECK(round_marks(3.0, 47.0, 5) == std::vector<double>{10.0, 20.0, 30.0, 40.0});
}

TEST_CASE("there are never many more marks than asked for", "[studio][plot]") {
    for (double high = 0.001; high < 1e6; high *= 1.7) {
        for (const int most : {1, 2, 4, 9})
            CHECK(round_marks(-0.3 * high, high, most).size() <=
                  static_cast<std::size_t>(most) + 1);
    }
}

TEST_CASE("an empty range has no marks and a flat one can still be drawn", "[studio][plot]") {
    CHECK(round_marks(1.0, 1.0, 5).empty());
    const Range flat = plot_range(2.0, 2.0);
    CHECK(flat.high > flat.low);
    CHECK(plot_range(0.0, 1.0).high > 1.0);
}

}  // namespace
}  // namespace cambrian
