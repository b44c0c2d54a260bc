// Opponents of contests, drawn for each generation.
#include "evolution/opponents.h"

#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evolution.h"
#include "evolution/fields/setting_field.h"
#include "evolution/individual/population_digest.h"
#include "evolution/settings/goal_defaults.h"
#include "support/catch.h"
#include "support/kinds.h"

#include <algorithm>

using namespace cambrian;
using test::kinds;

namespace {

std::shared_ptr<ExperimentSettings> contest() {
    auto settings = std::make_shared<ExperimentSettings>();
    settings->goal = "competition";
    adopt_defaults(*settings, *kinds().goals.find("competition"));
    settings->seed = 3;
    settings->population.size = 10;
    settings->world.trial.duration = 0.4;
    settings->world.trial.settle_limit = 0.3;
    return settings;
}

struct Run {
    std::vector<Opponents> opponents;  // of each generation
    std::vector<GenomePtr> champions;
    std::vector<std::uint64_t> digests;
};

Run run(std::size_t threads, int generations) {
    const auto backend = make_thread_pool_backend(kinds(), threads);
    Evolution evolution(contest(), kinds());
    EvaluationProgress progress;
    Run run;
    for (int generation = 0; generation < generations; ++generation) {
        if (generation > 0) evolution.breed();
        REQUIRE(evolution.evaluate(*backend, progress, {}));
        run.opponents.push_back(evolution.settings().world.opponents);
        run.champions.push_back(evolution.population().front()->genome);
        run.digests.push_back(population_digest(evolution.population()));
    }
    return run;
}

}  // namespace

TEST_CASE("opponents are the last champion and earlier ones", "[evolution][opponents]") {
    const Run done = run(1, 5);
    for (std::size_t generation = 0; generation < done.opponents.size(); ++generation) {
        const std::vector<GenomePtr>& opponents = done.opponents[generation].genomes;
        REQUIRE(opponents.size() == 3);
        if (generation == 0) continue;
        CHECK(*opponents.front() == *done.champions[generation - 1]);
        for (std::size_t i = 1; i < opponents.size(); ++i) {
            const auto earlier =
                done.champions.begin() +
                static_cast<std::ptrdiff_t>(std::max<std::size_t>(generation - 1, 1));
            CHECK(std::any_of(done.champions.begin(), earlier, [&](const GenomePtr& champion) {
                return *champion == *opponents[i];
            }));
        }
    }
}

TEST_CASE("a contest has the same bits on 1, 2 and 7 threads", "[evolution][opponents][threads]") {
    const Run alone = run(1, 4);
    CHECK(run(2, 4).digests == alone.digests);
    CHECK(run(7, 4).digests == alone.digests);
}

TEST_CASE("survivors are judged again in each generation of a contest", "[evolution][opponents]") {
    const auto backend = make_thread_pool_backend(kinds(), 1);
    Evolution evolution(contest(), kinds());
    EvaluationProgress progress;
    REQUIRE(evolution.evaluate(*backend, progress, {}));
    for (int generation = 1; generation < 4; ++generation) {
        evolution.breed();
        REQUIRE(evolution.evaluate(*backend, progress, {}));
        std::vector<std::uint64_t> phenotypes;
        for (const IndividualPtr& one : evolution.population())
            phenotypes.push_back(one->result.phenotype);
        std::sort(phenotypes.begin(), phenotypes.end());
        const auto last = std::unique(phenotypes.begin(), phenotypes.end());
        CHECK(evolution.history().back().evaluations == last - phenotypes.begin());
    }
}

TEST_CASE("settings changed by hand keep the opponents", "[evolution][opponents]") {
    const auto backend = make_thread_pool_backend(kinds(), 1);
    Evolution evolution(contest(), kinds());
    EvaluationProgress progress;
    REQUIRE(evolution.evaluate(*backend, progress, {}));
    const Opponents before = evolution.settings().world.opponents;
    auto changed = contest();
    changed->mutation.rate = 2.0;
    evolution.replace_settings(changed);
    CHECK(evolution.settings().world.opponents == before);
    auto walking = std::make_shared<ExperimentSettings>();
    walking->population.size = 10;
    evolution.replace_settings(walking);
    evolution.breed();
    REQUIRE(evolution.evaluate(*backend, progress, {}));
    CHECK(evolution.settings().world.opponents.genomes.empty());
}

TEST_CASE("a contest needs its cube", "[evolution][opponents]") {
    auto settings = contest();
    CHECK(check_settings(*settings, kinds()));
    settings->world.trial.has_cube = false;
    const Status missing = check_settings(*settings, kinds());
    REQUIRE_FALSE(missing);
    CHECK(missing.error().message ==
          "goal \"competition\" has no cube to fight for: set [trial] cube = true");
}
