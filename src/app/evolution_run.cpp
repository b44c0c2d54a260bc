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
#include "evolution/stopping.h"
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

// The creatures the run begins with; none for random ones.
Result<std::vector<GenomePtr>> founders_of(const EvolutionRun& run, int places,
                                           const EvolutionKinds& kinds) {
    if (run.founders.size() > static_cast<std::size_t>(places)) {
        return Error{"--founders: " + std::to_string(run.founders.size()) +
                     " creatures, but [population] size is " + std::to_string(places)};
    }
    std::vector<GenomePtr> founders;
    for (const std::string& file : run.founders) {
        Result<CreatureDocument> document = load_creature(file, kinds);
        if (!document) return document.error();
        say_of(file, document->warnings);
        founders.push_back(std::make_shared<const Genome>(std::move(document->genome)));
    }
    return founders;
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
    IndividualPtr champion;       // of the last generation evaluated; null if there was none
    std::string_view stopped_by;  // a stop_reason() or "interruption"
};

// Evaluates and breeds until the run is over.
Harvest evolve(Evolution& evolution, EvaluationBackend& backend, const std::string& unit,
               bool json) {
    Harvest harvest;
    const Interruption interruption;
    EvaluationProgress progress;
    const auto generations = static_cast<std::uint32_t>(evolution.settings().generations);
    ProgressBar bar(progress, generations);
    for (;;) {
        if (!evolution.evaluate(backend, progress, interruption.token())) {
            harvest.stopped_by = "interruption";
            return harvest;
        }
        harvest.champion = evolution.population().front();
        bar.finish_generation(generation_line(evolution.history().back(), unit, json));
        harvest.stopped_by = stop_reason(evolution.history(), evolution.settings());
        if (harvest.stopped_by.empty() && interruption.requested())
            harvest.stopped_by = "interruption";
        if (!harvest.stopped_by.empty()) return harvest;
        evolution.breed();
    }
}

}  // namespace

ExitStatus run_evolution(const EvolutionRun& run, const EvolutionKinds& kinds) {
    const Result<SettingsPtr> settings = settings_of(run, kinds);
    if (!settings) return fail(settings.error());
    for (const std::string& warning : setting_warnings(**settings, kinds))
        say(warning);
    const auto founders = founders_of(run, (*settings)->population.size, kinds);
    if (!founders) return fail(founders.error());
    const Result<std::filesystem::path> path =
        output_path(run.out, "champion-" + (*settings)->goal + "-seed" +
                                 std::to_string((*settings)->seed) + ".creature.json");
    if (!path) return fail(path.error());

    const auto backend =
        make_thread_pool_backend(kinds, run.threads.value_or(ThreadPool::default_workers()));
    const std::string unit = kinds.goals.find((*settings)->goal)->unit;
    Evolution evolution(*settings, kinds, *founders);
    const Harvest harvest = evolve(evolution, *backend, unit, run.json);
    if (!harvest.champion)
        return fail({"interrupted before the first generation was judged; nothing to save"},
                    ExitStatus::kFailed);

    CreatureDocument champion = creature_document(*harvest.champion, **settings, kinds);
    recompute_score(champion, kinds);
    const auto saved = save_champion(*path, champion, kinds);
    if (!saved) return fail(saved.error(), ExitStatus::kFailed);
    print_line(final_line(evolution.history(), unit, *harvest.champion, *saved, harvest.stopped_by,
                          run.json));
    return ExitStatus::kDone;
}

}  // namespace cambrian
