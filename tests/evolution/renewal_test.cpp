// Chance that is drawn again every so many generations.
#include "evolution/evaluation/trials.h"
#include "evolution/evolution.h"
#include "evolution/settings/chance.h"
#include "evolution/settings/goal_defaults.h"
#include "support/catch.h"
#include "support/fake_backend.h"
#include "support/kinds.h"

#include <set>

using namespace cambrian;
using test::FakeBackend;
using test::kinds;

namespace {

std::shared_ptr<ExperimentSettings> renewing(int generations) {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->goal = "seeking";
    adopt_defaults(*settings, *kinds().goals.find("seeking"));
    settings->population.size = 20;
    settings->world.trial.renewal = generations;
    return settings;
}

}  // namespace

TEST_CASE("scores are forgotten each time that chance is drawn again", "[evolution][renewal]") {
    Evolution evolution(renewing(3), kinds());
    FakeBackend backend;
    EvaluationProgress progress;
    std::vector<int> draws;
    for (int generation = 0; generation < 8; ++generation) {
        if (generation > 0) evolution.breed();
        REQUIRE(evolution.evaluate(backend, progress, {}));
        draws.push_back(evolution.settings().world.trial.draw);
        const bool all = generation % 3 == 0;
        INFO("generation " << generation);
        std::set<std::uint64_t> phenotypes;
        for (const IndividualPtr& one : evolution.population())
            phenotypes.insert(one->result.phenotype);
        const int evaluations = evolution.history().back().evaluations;
        CHECK((evaluations == static_cast<int>(phenotypes.size())) == all);
    }
    CHECK(draws == std::vector<int>{0, 0, 0, 1, 1, 1, 2, 2});
}

TEST_CASE("no draw has the seed of another, and the first has that of before draws were",
          "[evolution][renewal]") {
    ExperimentSettings settings;
    CHECK(trial_seed(settings) == stream_seed(settings.seed, 0, 0, Purpose::kTrial));
    std::set<std::uint64_t> seeds;
    for (settings.world.trial.draw = 0; settings.world.trial.draw < 100;
         ++settings.world.trial.draw)
        seeds.insert(trial_seed(settings));
    CHECK(seeds.size() == 100);
}

TEST_CASE("settings changed by hand never go back to an earlier draw", "[evolution][renewal]") {
    Evolution evolution(renewing(1), kinds());
    FakeBackend backend;
    EvaluationProgress progress;
    for (int generation = 0; generation < 3; ++generation) {
        if (generation > 0) evolution.breed();
        REQUIRE(evolution.evaluate(backend, progress, {}));
    }
    CHECK(evolution.settings().world.trial.draw == 2);
    auto changed = renewing(0);
    changed->world.environment.light_reach = 1.0;
    evolution.replace_settings(changed);
    CHECK(evolution.settings().world.trial.draw == 2);
    evolution.breed();
    REQUIRE(evolution.evaluate(backend, progress, {}));
    CHECK(evolution.settings().world.trial.draw == 2);
}

TEST_CASE("other goals draw once", "[evolution][renewal]") {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->population.size = 10;
    Evolution evolution(settings, kinds());
    FakeBackend backend;
    EvaluationProgress progress;
    for (int generation = 0; generation < 12; ++generation) {
        if (generation > 0) evolution.breed();
        REQUIRE(evolution.evaluate(backend, progress, {}));
    }
    CHECK(evolution.settings().world.trial.draw == 0);
}

TEST_CASE("chance has a part in trials that draw something", "[evolution][renewal]") {
    const auto drawn_after = [](void (*change)(TrialWorld & world)) {
        TrialWorld world;
        change(world);
        return has_chance(world);
    };
    CHECK_FALSE(drawn_after([](TrialWorld&) {}));
    CHECK(drawn_after([](TrialWorld& world) { world.environment.has_wall = true; }));
    CHECK_FALSE(drawn_after([](TrialWorld& world) { world.environment.has_light = true; }));
    CHECK(drawn_after([](TrialWorld& world) {
        world.environment.has_light = true;
        world.environment.light_motion = "jumping";
    }));
    CHECK_FALSE(drawn_after([](TrialWorld& world) { world.environment.terrain.same = false; }));
    CHECK(drawn_after([](TrialWorld& world) {
        world.environment.terrain.kind = "rough";
        world.environment.terrain.same = false;
    }));
    CHECK(drawn_after([](TrialWorld& world) {
        world.trial.trials = 2;
        world.trial.tilt_jitter = 1.0;
    }));
}
