#include "evolution/engine/stopping.h"

#include "support/catch.h"

#include <vector>

using namespace cambrian;

TEST_CASE("a run ends at its target, its evaluations or its generations", "[evolution]") {
    ExperimentSettings settings;
    settings.generations = 3;
    settings.max_evaluations = 50;
    std::vector<GenerationStatistics> history;
    CHECK(stop_reason(history, settings).empty());
    const auto add = [&](int evaluations, double best) {
        GenerationStatistics next;
        next.evaluations = evaluations;
        next.best = best;
        history.push_back(next);
        return stop_reason(history, settings);
    };
    CHECK(add(20, 5.0).empty());
    CHECK(add(29, 6.0).empty());
    settings.target_fitness = 6.0;
    CHECK(stop_reason(history, settings) == "target-fitness");
    settings.target_fitness = 0.0;
    CHECK(add(1, 6.0) == "evaluations");
    settings.max_evaluations = 51;
    CHECK(stop_reason(history, settings) == "generations");
}
