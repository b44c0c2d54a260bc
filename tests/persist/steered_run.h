#pragma once

// A small evolution with commands during the run, saved in a log.

#include "evolution/backends/thread_pool_backend.h"
#include "evolution/engine/experiment_log.h"
#include "evolution/evolution.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <memory>
#include <string>
#include <vector>

namespace cambrian::test {

inline ExperimentSettings small_settings(const std::string& selection = "truncation") {
    ExperimentSettings settings;
    settings.seed = 5;
    settings.population.size = 14;
    settings.world.trial.duration = 0.5;
    settings.world.trial.settle_limit = 0.5;
    settings.selection.method = selection;
    return settings;
}

inline std::vector<NotedCommand> some_steering(const ExperimentSettings& settings) {
    ExperimentSettings moon = settings;
    moon.world.environment.gravity = 1.62;
    ExperimentSettings patient = moon;
    patient.mutation.rate = 2.5;
    return {{1, AddImmigrants{0.3}},
            {2, ChangeSettings{std::make_shared<const ExperimentSettings>(moon)}},
            {3, ChangeSettings{std::make_shared<const ExperimentSettings>(patient)}},
            {3, InjectGenome{crawler(kinds().creature.catalog)}},
            {4, RescorePopulation{}}};
}

// Evaluates and records until there are `generations` in total.
template <class Log>
void run_on(Evolution& evolution, Log& log, std::size_t generations,
            const std::vector<NotedCommand>& steering = {}) {
    const auto backend = make_thread_pool_backend(kinds(), 2);
    EvaluationProgress progress;
    while (evolution.history().size() < generations) {
        if (evolution.evaluated()) evolution.breed();
        for (const NotedCommand& noted : steering) {
            if (noted.generation == evolution.generation()) REQUIRE(log.note(noted));
        }
        give_commands(evolution, steering);
        REQUIRE(evolution.evaluate(*backend, progress, {}));
        REQUIRE(log.record(evolution));
    }
}

}  // namespace cambrian::test
