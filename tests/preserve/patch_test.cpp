// Patches of light, around which plants grow.
#include "worlds.h"

#include <catch2/catch.hpp>

#include <cmath>

namespace cambrian {
namespace {

using namespace test;

TEST_CASE("plants grow around patches of light, each as often", "[preserve][patch]") {
    ExperimentSettings settings = small_world();
    settings.preserve.plant_energy = 1.0;
    settings.preserve.patches = "-3 0 0.5; 3 -4.9 0.5";
    const auto preserve = begun(settings, {eater(0.0)});
    const auto plants = preserve->plants().all();
    REQUIRE(plants.size() > 2000);
    double first = 0.0;
    double square = 0.0;
    for (const Pellet& plant : plants) {
        const bool is_first = plant.x < 0.0;
        CHECK(std::fabs(plant.x - (is_first ? -3.0 : 3.0)) < 2.0);
        CHECK(plant.y >= -5.0);
        if (!is_first) continue;
        first += 1.0;
        square += plant.y * plant.y;
    }
    CHECK(std::sqrt(square / first) == Approx(0.5).epsilon(0.1));
    // Of the other one, more than a third falls outside and is drawn again, at either.
    CHECK(first / static_cast<double>(plants.size()) > 0.5);
    CHECK(first / static_cast<double>(plants.size()) < 0.75);
    CHECK(preserve->total_energy() == preserve->founding_energy());
}

TEST_CASE("a patch out of the world falls back to plants everywhere only where it must",
          "[preserve][patch]") {
    ExperimentSettings settings = small_world();
    settings.preserve.patches = "6 5 500";
    const auto preserve = begun(settings, {eater(0.0)});
    double left = 0.0;
    for (const Pellet& plant : preserve->plants().all())
        left += plant.x < 0.0 ? 1.0 : 0.0;
    const auto all = static_cast<double>(preserve->plants().all().size());
    CHECK(left / all == Approx(0.5).margin(0.15));
}

}  // namespace
}  // namespace cambrian
