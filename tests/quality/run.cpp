#include "quality/run.h"

#include "core/hash.h"
#include "core/thread_time.h"
#include "creature/phenotype.h"
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evaluation/trials.h"
#include "evolution/evolution.h"
#include "evolution/individual/map_axis.h"
#include "goals/sampling.h"
#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"
#include "quality/arm.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cambrian::quality {
namespace {

constexpr double kLate = 0.7;  // share of the test after which a walker must still move

Result<ExperimentSettings> base_settings(const RunSpec& spec, const EvolutionKinds& kinds) {
    if (spec.settings.empty()) return default_settings(spec.goal, kinds);
    const std::filesystem::path samples = CAMBRIAN_SOURCE_DIR "/assets/settings";
    return load_settings(samples / spec.settings, kinds);
}

Result<SettingsPtr> settings_of(const RunSpec& spec, const EvolutionKinds& kinds) {
    auto base = base_settings(spec, kinds);
    if (!base) return base.error();
    auto settings = std::make_shared<ExperimentSettings>(std::move(*base));
    settings->seed = spec.seed;
    settings->population.size = spec.size;
    arm_of(spec.arm).change(*settings);
    return SettingsPtr(std::move(settings));
}

// Collects measurements of an evolution after each generation.
class Observer {
public:
    explicit Observer(const RunSpec& spec) { static_cast<RunSpec&>(result_) = spec; }

    void see(const Evolution& evolution) {
        const GenerationStatistics& statistics = evolution.history().back();
        result_.evaluations += statistics.evaluations;
        ++result_.generations;
        result_.invalid_share += statistics.invalid_share;
        result_.decreased = result_.decreased || statistics.best < result_.final_best;
        result_.final_best = statistics.best;
        if (!budget_used_) result_.best = statistics.best;
        budget_used_ = result_.evaluations >= result_.budget;
        result_.curve.push_back({result_.evaluations, statistics.best});
        hash_.add(statistics.best);
        hash_.add(statistics.mean);
        see_creatures(evolution);
    }

    bool done() const {
        const RunSpec& spec = result_;
        if (result_.generations >= std::max(spec.most_generations, spec.least_generations))
            return true;
        return budget_used_ && result_.generations >= spec.least_generations;
    }

    RunResult finish(const ExperimentSettings& settings) {
        std::vector<IndividualPtr> elites;
        for (const auto& [cell, elite] : archive_)
            elites.push_back(elite);
        const MapCoverage coverage = map_coverage(elites, settings);
        result_.cells = coverage.filled_cells;
        result_.quality = coverage.quality;
        result_.invalid_share /= std::max(1, result_.generations);
        result_.digest = hash_.value();
        return std::move(result_);
    }

    Hash64& hash() { return hash_; }

private:
    void see_creatures(const Evolution& evolution) {
        for (const IndividualPtr& creature : evolution.population()) {
            if (creature->born == evolution.generation()) count_child(*creature);
            if (!disqualified(*creature)) keep_elite(creature, evolution.settings());
        }
        fitness_.clear();
        for (const IndividualPtr& creature : evolution.population())
            fitness_[creature->uid] = creature->result.fitness;
    }

    void count_child(const Individual& child) {
        double fittest = 0.0;
        for (const std::uint64_t parent : child.parents) {
            if (parent == 0) continue;
            const auto known = fitness_.find(parent);
            if (known == fitness_.end()) return;
            fittest = std::max(fittest, known->second);
        }
        if (child.parents[0] == 0) return;
        Offspring& offspring = result_.offspring[child.method];
        ++offspring.born;
        offspring.improved += child.result.fitness > fittest ? 1 : 0;
    }

    void keep_elite(const IndividualPtr& creature, const ExperimentSettings& settings) {
        IndividualPtr& elite = archive_[cell_of(creature->result, settings)];
        if (!elite || better(*creature, *elite)) elite = creature;
    }

    RunResult result_;
    bool budget_used_ = false;
    Hash64 hash_;
    std::map<std::uint64_t, double> fitness_;  // fitness in the generation before, by uid
    std::map<MapCell, IndividualPtr> archive_;
};

void judge_champion(RunResult& result, const Individual& champion,
                    const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    result.finer = recompute(*champion.genome, settings, kinds).score;
    result.clean = champion.result.verdict == AuditVerdict::kClean;
    const auto phenotype = std::make_shared<const Phenotype>(
        express(*champion.genome, kinds.creature, settings.expression, settings.world.scene));
    const auto record = run_trial(phenotype, kinds.creature, first_trial_world(settings));
    if (!record || record->samples.empty()) return;
    result.reversals = record->reversal_rate;
    const double travelled =
        sample_at(*record, 1.0).center_of_mass.x() - sample_at(*record, kLate).center_of_mass.x();
    result.late_travel = std::fabs(travelled) / record->body_length;
}

void save_champion(const RunSpec& spec, const JudgedIndividual& champion,
                   const EvolutionKinds& kinds, const std::filesystem::path& folder) {
    if (folder.empty()) return;
    const std::string name = spec.plan + "-" + spec.goal + "-" + spec.arm + "-" +
                             std::to_string(spec.seed) + ".creature.json";
    const Status saved = save_creature(folder / name, creature_document(champion, kinds), kinds);
    if (!saved) std::fprintf(stderr, "%s\n", saved.error().message.c_str());
}

}  // namespace

Result<RunResult> perform(const RunSpec& spec, const EvolutionKinds& kinds,
                          const std::filesystem::path& champions) {
    const double begun = thread_cpu_time();
    const auto made = settings_of(spec, kinds);
    if (!made) return made.error();
    const SettingsPtr& settings = *made;
    const auto backend = make_thread_pool_backend(kinds, 1);
    Evolution evolution(settings, kinds);
    EvaluationProgress progress;
    Observer observer(spec);
    for (;;) {
        evolution.evaluate(*backend, progress, {});
        observer.see(evolution);
        if (observer.done()) break;
        evolution.breed();
    }
    const Individual& champion = *evolution.population().front();
    observer.hash().add(champion.result.digest);
    RunResult result = observer.finish(*settings);
    judge_champion(result, champion, *settings, kinds);
    if (kinds.goals.find(spec.goal)->shares != nullptr)
        result.best = result.final_best = held_out_score(champion.genome, *settings, kinds);
    save_champion(spec, {.individual = evolution.population().front(), .settings = settings}, kinds,
                  champions);
    result.seconds = thread_cpu_time() - begun;
    return result;
}

}  // namespace cambrian::quality
