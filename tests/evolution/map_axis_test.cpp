#include "evolution/individual/map_axis.h"

#include "support/catch.h"
#include "support/individuals.h"

using namespace cambrian;

namespace {

EvaluationResult of_mass(double mass) {
    EvaluationResult result;
    result.mass = mass;
    return result;
}

}  // namespace

TEST_CASE("mass is sorted into ten bins of equal ratio from 20 g to 20 kg", "[evolution][map]") {
    const MapAxis& mass = map_axis("mass");
    CHECK(bin_on(mass, of_mass(0.0)) == 0);
    CHECK(bin_on(mass, of_mass(0.039)) == 0);
    CHECK(bin_on(mass, of_mass(0.041)) == 1);
    CHECK(bin_on(mass, of_mass(0.63)) == 4);
    CHECK(bin_on(mass, of_mass(0.64)) == 5);
    CHECK(bin_on(mass, of_mass(19.0)) == 9);
    CHECK(bin_on(mass, of_mass(1e9)) == 9);
}

TEST_CASE("in space, masses from 0.5 kg to 2 t are told apart", "[evolution][map]") {
    ExperimentSettings settings;
    settings.selection.map_up = "mass";
    settings.world.environment.dimensions = 3;
    CHECK(cell_of(of_mass(0.4), settings).up == 0);
    CHECK(cell_of(of_mass(31.0), settings).up == 4);
    CHECK(cell_of(of_mass(32.0), settings).up == 5);
    CHECK(cell_of(of_mass(1900.0), settings).up == 9);
}

TEST_CASE("every number of parts has a bin of its own", "[evolution][map]") {
    for (int parts = 1; parts <= 16; ++parts) {
        EvaluationResult result;
        result.parts = parts;
        CHECK(bin_on(map_axis("parts"), result) == parts - 1);
    }
}

TEST_CASE("coverage counts cells and sums the best of each", "[evolution][map]") {
    auto all = test::individuals({3.0, 2.0, 5.0, -1.0, 9.0});
    const int parts[] = {1, 1, 2, 3, 4};
    for (std::size_t i = 0; i < all.size(); ++i) {
        Individual changed = *all[i];
        changed.result.parts = parts[i];
        if (i == 4) changed.result.outcome = Outcome::kDisqualified;
        all[i] = std::make_shared<const Individual>(changed);
    }
    const MapCoverage coverage = map_coverage(all, ExperimentSettings{});
    CHECK(coverage.filled_cells == 3);
    CHECK(coverage.quality == 8.0);
}
