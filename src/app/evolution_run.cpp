#include "app/evolution_run.h"

#include "app/evolution_report.h"
#include "app/interruption.h"
#include "app/messages.h"
#include "app/output_path.h"
#include "app/progress_bar.h"
#include "core/thread_pool.h"
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evolution.h"
#include "evolution/setting_field.h"
#include "persist/creature_file.h"
#include "persist/settings_file.h"

#include <memory>
#include <span>
#include <system_error>
#include <unistd.h>

namespace cambrian {
namespace {

Result<SettingsPtr> settings_of(const EvolutionRun& run, const EvolutionKinds& kinds) {
    Result<ExperimentSettings> settings = load_settings(run.settings_file, kinds);
    if (!settings) return settings.error();
    settings->generations = run.generations.value_or(settings->generations);
    settings->seed = run.seed.value_or(settings->seed);
    if (const Status valid = check_settings(*settings, kinds); !valid) return valid.error();
    return std::make_shared<const ExperimentSettings>(*std::move(settings));
}

// Where it should go or, if that has become impossible meanwhile, where it is not lost.
Result<std::filesystem::path> save_champion(const std::filesystem::path& path,
                                            const CreatureDocument& champion,
                                            const EvolutionKinds& kinds) {
    const Status saved = save_creature(path, champion, kinds);
    if (saved) return path;
    std::error_code failure;
    const std::filesystem::path refuge =
        std::filesystem::temp_directory_path(failure) /
        ("rescued-" + std::to_string(::getpid()) + "-" + path.filename().string());
    if (failure || !save_creature(refuge, champion, kinds)) return saved.error();
    return Error{saved.error().message + "; the champion is in " + refuge.string()};
}

// What an evolution came to.
struct Harvest {
    IndividualPtr champion;  // of the last generation evaluated; null if there was none
    bool interrupted = false;
};

// Evaluates and breeds until the last generation or an interruption.
Harvest evolve(Evolution& evolution, EvaluationBackend& backend, const std::string& unit,
               bool json) {
    Harvest harvest;
    const Interruption interruption;
    EvaluationProgress progress;
    const auto generations = static_cast<std::uint32_t>(evolution.settings().generations);
    ProgressBar bar(progress, generations);
    for (;;) {
        harvest.interrupted = !evolution.evaluate(backend, progress, interruption.token());
        if (harvest.interrupted) return harvest;
        harvest.champion = evolution.population().front();
        bar.finish_generation(generation_line(evolution.history().back(), unit, json));
        if (evolution.history().size() >= generations) return harvest;
        evolution.breed();
    }
}

}  // namespace

ExitStatus run_evolution(const EvolutionRun& run, const EvolutionKinds& kinds) {
    const Result<SettingsPtr> settings = settings_of(run, kinds);
    if (!settings) return fail(settings.error());
    const Result<std::filesystem::path> path =
        output_path(run.out, "champion-" + (*settings)->goal + "-seed" +
                                 std::to_string((*settings)->seed) + ".creature.json");
    if (!path) return fail(path.error());

    const auto backend =
        make_thread_pool_backend(kinds, run.threads.value_or(ThreadPool::default_workers()));
    const std::string unit = kinds.goals.find((*settings)->goal)->unit;
    Evolution evolution(*settings, kinds);
    const Harvest harvest = evolve(evolution, *backend, unit, run.json);
    if (!harvest.champion)
        return fail({"interrupted before the first generation was judged; nothing to save"},
                    ExitStatus::kFailed);

    CreatureDocument champion = creature_document(*harvest.champion, **settings, kinds);
    recompute_score(champion, kinds);
    const auto saved = save_champion(*path, champion, kinds);
    if (!saved) return fail(saved.error(), ExitStatus::kFailed);
    print_line(final_line(evolution.history(), unit, *saved, harvest.interrupted, run.json));
    return ExitStatus::kDone;
}

}  // namespace cambrian
