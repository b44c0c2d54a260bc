#include "comparison/compared_run.h"

#include "core/hash.h"
#include "core/random.h"
#include "core/sample_statistics.h"
#include "core/thread_time.h"
#include "creature/phenotype.h"
#include "evolution/evaluation/sense_losses.h"
#include "evolution/evaluation/trials.h"
#include "evolution/evolution.h"
#include "evolution/generation.h"
#include "genome/genome.h"
#include "persist/settings/settings_file.h"
#include "persist/text/digest_text.h"
#include "simulator/simulator_version.h"
#include "simulator/trial.h"

#include <algorithm>
#include <memory>
#include <set>

namespace cambrian {
namespace {

constexpr int kJudgingWorlds = 10;
// Changes of the worlds that confirm the champion.
constexpr double kJudgingJitter = 0.01;  // relative, of gravity, friction and drag
constexpr double kJudgingTilt = 2.0;     // degrees, of the ground
// Index that keeps their random streams apart from those of survivor selection.
constexpr std::uint64_t kJudging = 1'000;
constexpr std::size_t kBest = 20;  // number of survivors whose body plans are counted

double confirmed_score(const GenomePtr& genome, ExperimentSettings settings,
                       const EvolutionKinds& kinds) {
    settings.selection.confirm_jitter = kJudgingJitter;
    settings.selection.confirm_tilt = kJudgingTilt;
    std::vector<Probe> probes;
    for (std::uint64_t world = 0; world < kJudgingWorlds; ++world)
        probes.push_back({stream_seed({trial_seed(settings), kJudging, world})});
    return median(scores_in(probes, genome, settings, kinds));
}

double accurate_score(const GenomePtr& genome, const ExperimentSettings& settings,
                      const EvolutionKinds& kinds) {
    return evaluate_in_trials({.genome = genome, .trial_seed = trial_seed(settings)},
                              accurate_settings(settings, kinds), kinds)
        .fitness;
}

double jump_height(const GenomePtr& genome, const ExperimentSettings& settings,
                   const EvolutionKinds& kinds) {
    const auto record =
        run_trial(grow(*genome, settings, kinds), kinds.creature, first_trial_world(settings));
    const double gravity = settings.world.environment.gravity;
    if (!record || !(gravity > 0.0)) return 0.0;
    const double speed = std::max(0.0, record->jumps.best().take_off_speed);
    return speed * speed / (2.0 * gravity);
}

int plans_of_best(const Evolution& evolution, const EvolutionKinds& kinds) {
    std::set<std::uint64_t> plans;
    std::size_t seen = 0;
    for (const std::size_t survivor :
         survivors_of(evolution.population(), evolution.settings(), kinds,
                      evolution.generation() + 1, evolution.selection_memory())) {
        plans.insert(evolution.population()[survivor]->result.plan);
        if (++seen == kBest) break;
    }
    return static_cast<int>(plans.size());
}

void note_generation(ComparedRun& row, const GenerationStatistics& statistics) {
    row.evaluations += statistics.evaluations;
    row.time_saved += (statistics.time_saved - row.time_saved) / ++row.generations;
    row.lines = statistics.lines;
    row.curve.push_back({row.evaluations, statistics.best});
}

void note_end(ComparedRun& row, const Evolution& evolution, const Individual& champion,
              const EvolutionKinds& kinds, const std::stop_token& stop) {
    const ExperimentSettings& settings = evolution.settings();
    row.score = champion.result.fitness;
    row.parts = champion.result.parts;
    row.confirmed = confirmed_score(champion.genome, settings, kinds);
    row.finer = accurate_score(champion.genome, settings, kinds);
    row.jump_height = jump_height(champion.genome, settings, kinds);
    row.needs_senses = needs_senses(champion.genome, settings, kinds, stop) ? 1 : 0;
    row.plans = plans_of_best(evolution, kinds);
    row.audited = evolution.termination_audit().finished;
    row.survivors = evolution.termination_audit().survived;
}

}  // namespace

ComparedRun planned_row(const PlannedRun& run, const EvolutionKinds& kinds) {
    ComparedRun row;
    row.world = run.world;
    row.arm = run.arm;
    row.seed = run.settings->seed;
    row.trials = run.trials;
    Hash64 hash;
    hash.add(digested_settings(*run.settings, kinds));
    for (const GenomePtr& founder : run.founders)
        hash.add(genome_hash(*founder));
    row.settings = hex_text(hash.value());
    row.simulator = simulator_version(kinds.creature.scene.dimensions);
    return row;
}

bool is_row_of(const ComparedRun& finished, const ComparedRun& planned) {
    return finished.world == planned.world && finished.arm == planned.arm &&
           finished.seed == planned.seed && finished.trials == planned.trials &&
           finished.settings == planned.settings && finished.simulator == planned.simulator;
}

std::optional<FinishedRun> perform(const PlannedRun& run, const EvolutionKinds& kinds,
                                   EvaluationBackend& backend, std::atomic<std::uint64_t>& done,
                                   const std::stop_token& stop) {
    const double begun = thread_cpu_time();
    EvaluationProgress progress;
    Evolution evolution(run.settings, kinds, run.founders);
    ComparedRun row = planned_row(run, kinds);
    for (;;) {
        if (!evolution.evaluate(backend, progress, stop)) return std::nullopt;
        const GenerationStatistics& latest = evolution.history().back();
        note_generation(row, latest);
        done += static_cast<std::uint64_t>(latest.evaluations);
        if (row.evaluations >= run.trials || stop.stop_requested()) break;
        evolution.breed();
    }
    const auto champion = evolution.confirmed_champion(backend, progress, stop);
    if (!champion) return std::nullopt;
    note_end(row, evolution, **champion, kinds, stop);
    row.seconds = thread_cpu_time() - begun;
    return FinishedRun{std::move(row), *champion, evolution.shared_settings()};
}

}  // namespace cambrian
