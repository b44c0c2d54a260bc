#include "studio/widgets/plot.h"

#include "support/catch.h"

#include <algorithm>

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

TEST_CASE("marks are at round values inside the range", "[studio][plot]") {
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

// A curve with a thousand points in ten pixels.
struct DenseCurve {
    DenseCurve() {
        for (int i = 0; i < 1000; ++i) {
            xs.push_back(i);
            ys.push_back(i % 7);
        }
        ys[503] = 1000.0;
        ys[704] = -1000.0;
    }
    std::vector<double> xs;
    std::vector<double> ys;
    PlotScale scale{{0.0F, 0.0F, 10.0F, 100.0F}, 0.0, 1000.0, -1000.0, 1000.0};
};

TEST_CASE("a dense curve keeps its ends and its extremes, a few points a pixel", "[studio][plot]") {
    const DenseCurve curve;
    const std::vector<std::size_t> kept = thinned(curve.scale, curve.xs, curve.ys);
    CHECK(kept.size() <= 40);
    CHECK(std::is_sorted(kept.begin(), kept.end()));
    for (const std::size_t needed : std::vector<std::size_t>{0, 503, 704, 999})
        CHECK(std::count(kept.begin(), kept.end(), needed) == 1);
}

TEST_CASE("a sparse curve keeps every point", "[studio][plot]") {
    const std::vector<double> xs = {0.0, 1.0, 2.0, 20.0};
    const std::vector<double> ys = {1.0, 1.0, 3.0, 0.0};
    CHECK(thinned(kScale, xs, ys) == std::vector<std::size_t>{0, 1, 2, 3});
    CHECK(thinned(kScale, {}, {}).empty());
}

TEST_CASE("a dense band has one extent a pixel that covers all of its points", "[studio][plot]") {
    const DenseCurve curve;
    const auto columns = band_columns(curve.scale, curve.xs, curve.ys, curve.ys);
    REQUIRE(columns.size() == 10);
    CHECK(columns[5].upper == 1000.0);
    CHECK(columns[5].lower == 0.0);
    CHECK(columns[7].lower == -1000.0);
}

TEST_CASE("an empty range has no marks and a flat one can still be drawn", "[studio][plot]") {
    CHECK(round_marks(1.0, 1.0, 5).empty());
    const PlotRange flat = plot_range(2.0, 2.0);
    CHECK(flat.high > flat.low);
    CHECK(plot_range(0.0, 1.0).high > 1.0);
}

}  // namespace
}  // namespace cambrian
