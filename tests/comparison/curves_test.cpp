#include "comparison/curves.h"

#include <catch2/catch.hpp>

using namespace cambrian;

namespace {

ComparedRun run_with(std::vector<CurvePoint> curve) {
    ComparedRun run;
    run.trials = 100;
    run.curve = std::move(curve);
    return run;
}

}  // namespace

TEST_CASE("a band is the quartiles of the runs at equal trials", "[comparison]") {
    const CurveBand band = band_of({run_with({{50, 1.0}, {110, 5.0}}), run_with({{50, 2.0}}),
                                    run_with({{20, 0.0}, {100, 3.0}})},
                                   4);
    // At 25, not every run has a generation yet.
    CHECK(band.trials == std::vector<double>{50, 75, 100});
    CHECK(band.middle == std::vector<double>{1.0, 1.0, 2.0});
    CHECK(band.lower == std::vector<double>{0.5, 0.5, 1.5});
    CHECK(band.upper == std::vector<double>{1.5, 1.5, 2.5});
}

TEST_CASE("without runs there is no band", "[comparison]") {
    CHECK(band_of({}, 10).trials.empty());
}
