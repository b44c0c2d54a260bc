// The ladder of terrain, which raises its level as the median survivor keeps up.
#include "evolution/evaluation/terrain_ladder.h"

#include "evolution/evolution.h"
#include "support/catch.h"
#include "support/fake_backend.h"
#include "support/kinds.h"

using namespace cambrian;
using test::FakeBackend;
using test::kinds;

namespace {

std::shared_ptr<ExperimentSettings> climbing(double level, bool ladder) {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = 20;
    settings->selection.confirmations = 0;
    settings->world.environment.terrain = {.kind = "rough", .level = level, .ladder = ladder};
    return settings;
}

// Evaluates generations in which everyone scores `share(level)` of what they do at level 0.2, and
// returns the level of each.
std::vector<double> levels(const SettingsPtr& settings, int generations, double (*share)(double)) {
    Evolution evolution(settings, kinds());
    FakeBackend backend;
    backend.under = [share](double plain, const ExperimentSettings& under) {
        return plain * share(under.world.environment.terrain.level);
    };
    EvaluationProgress progress;
    std::vector<double> seen;
    for (int generation = 0; generation < generations; ++generation) {
        if (generation > 0) evolution.breed();
        backend.stop_after = 0;  // a stop and a repeated call change nothing
        CHECK_FALSE(evolution.evaluate(backend, progress, {}));
        REQUIRE(evolution.evaluate(backend, progress, {}));
        seen.push_back(evolution.settings().world.environment.terrain.level);
        CHECK(evolution.history().back().terrain_level == seen.back());
    }
    return seen;
}

}  // namespace

TEST_CASE("a ladder rises before each generation whose survivors keep up, to its top",
          "[evolution][ladder]") {
    const auto unhindered = [](double) { return 1.0; };
    CHECK(levels(climbing(0.9, true), 5, unhindered) ==
          std::vector<double>{0.9, 0.95, 1.0, 1.0, 1.0});
    CHECK(levels(climbing(0.9, false), 3, unhindered) == std::vector<double>{0.9, 0.9, 0.9});
}

TEST_CASE("a ladder stops where survivors keep less than 60 % of their score at level 0.2",
          "[evolution][ladder]") {
    const auto hindered = [](double level) { return level > 0.27 ? 0.5 : 1.0; };
    const std::vector<double> seen = levels(climbing(0.2, true), 6, hindered);
    CHECK(seen == std::vector<double>{0.2, 0.25, 0.3, 0.3, 0.3, 0.3});
}

TEST_CASE("settings changed by hand do not lower a ladder", "[evolution][ladder]") {
    Evolution evolution(climbing(0.5, true), kinds());
    evolution.replace_settings(climbing(0.3, true));
    CHECK(evolution.settings().world.environment.terrain.level == 0.5);
    evolution.replace_settings(climbing(0.3, false));
    CHECK(evolution.settings().world.environment.terrain.level == 0.3);
}
