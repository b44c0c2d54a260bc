#include "core/hash.h"
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evolution.h"
#include "evolution/individual/population_digest.h"
#include "evolution/settings/goal_defaults.h"
#include "golden/founders.h"
#include "golden/golden.h"
#include "support/kinds.h"

namespace cambrian::golden {
namespace {

constexpr std::uint32_t kGenerations = 20;
constexpr std::uint32_t kGenerationsInSpace = 4;
constexpr double kTrialOfRun = 3.0;  // s

// Returns the settings of run.toml, with which tests/cli/same_bits_test.py runs the program.
SettingsPtr settings() {
    auto made = std::make_shared<ExperimentSettings>();
    made->seed = 31;
    made->population.size = 20;
    made->population.tuned = 0.0;
    made->world.trial.duration = kTrialOfRun;
    made->founders = all_joints();
    return made;
}

SettingsPtr settings_in_space() {
    auto made = std::make_shared<ExperimentSettings>();
    adopt_space_defaults(*made, test::spatial_kinds().goals);
    made->seed = 31;
    made->population.size = 12;
    made->world.trial.duration = kTrialOfRun;
    return made;
}

void add_evolution(Digests& digests, const std::string& name, const EvolutionKinds& kinds,
                   SettingsPtr settings, std::uint32_t generations, std::size_t threads) {
    const auto backend = make_thread_pool_backend(kinds, threads);
    Evolution evolution(std::move(settings), kinds);
    EvaluationProgress progress;
    Hash64 all;
    while (evolution.evaluate(*backend, progress, {})) {
        add_population(all, evolution.population());
        if (evolution.history().size() == generations) break;
        evolution.breed();
    }
    const std::string run = name + std::to_string(threads) + "_threads";
    digests.push_back({run + ".champion", evolution.population().front()->genome_hash});
    digests.push_back({run + ".generations", all.value()});
    digests.push_back({run + ".last", population_digest(evolution.population())});
}

}  // namespace

void add_evolution_digests(Digests& digests) {
    for (const std::size_t threads : {1U, 2U, 7U})
        add_evolution(digests, "evolution.", test::kinds(), settings(), kGenerations, threads);
    for (const std::size_t threads : {1U, 7U})
        add_evolution(digests, "space.evolution.", test::spatial_kinds(), settings_in_space(),
                      kGenerationsInSpace, threads);
}

}  // namespace cambrian::golden
