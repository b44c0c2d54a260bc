#include "app/evolve/evolution_run.h"

#include "app/cluster/cluster_options.h"
#include "app/cluster/cluster_watch.h"
#include "app/command_line/started_file.h"
#include "app/evolve/evolution_report.h"
#include "app/evolve/run_museum.h"
#include "app/evolve/run_outputs.h"
#include "app/process/interruption.h"
#include "app/process/messages.h"
#include "app/process/progress_bar.h"
#include "app/trial/founder_files.h"
#include "app/trial/score_notice.h"
#include "cluster/join_cluster.h"
#include "core/text/shell_word.h"
#include "core/threads/thread_pool.h"
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/engine/stopping.h"
#include "evolution/evaluation/trials.h"
#include "evolution/evolution.h"
#include "evolution/fields/setting_changes.h"
#include "evolution/settings/chance.h"
#include "persist/creature/creature_file.h"
#include "persist/creature/rescoring.h"
#include "persist/experiment/experiment_file.h"
#include "persist/experiment/experiment_parts.h"
#include "persist/settings/settings_file.h"
#include "persist/settings/typed_setting.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <system_error>

namespace cambrian {
namespace {

Result<SettingsPtr> settings_of(const EvolutionRun& run, const EvolutionKinds& kinds) {
    const Result<SettingsText> text = read_settings_text(run.settings_file);
    if (!text) return text.error();
    Result<ExperimentSettings> settings = parse_settings(text->text, text->source, kinds);
    if (!settings) return settings.error();
    if (!run.sets.empty()) settings = merge_typed(*text, run.sets, kinds);
    if (!settings) return Error{"--set: " + settings.error().message};
    settings->generations = run.generations.value_or(settings->generations);
    if (!run.seeds.empty()) settings->seed = run.seeds.front();
    if (const Status valid = check_settings(*settings, kinds); !valid) return valid.error();
    return std::make_shared<const ExperimentSettings>(*std::move(settings));
}

// The evolution to run, its limits and its files.
struct Course {
    Evolution evolution;
    ExperimentSettings limits;  // tells when the run ends
    StartedFile made;           // of this start; it is removed after `file` is closed
    std::shared_ptr<ExperimentFile> file;
    RunOutputs outputs;
    // The experiment that is continued, if any.
    std::optional<SavedExperiment> before = std::nullopt;
};

// Gives the experiment its name. If another run has taken it meanwhile, the next free ones are
// tried.
Result<RunOutputs> take_names(ExperimentFile& file, RunOutputs outputs, const EvolutionRun& run,
                              const ExperimentSettings& settings) {
    for (;;) {
        const Status named = file.move_to(outputs.experiment, ExperimentFile::Existing::kRefuse);
        if (named) return outputs;
        Result<RunOutputs> others = run_outputs({run.out, settings, files_of(run)});
        if (!others) return others;
        if (others->experiment == outputs.experiment) return named.error();
        outputs = *std::move(others);
    }
}

Result<Course> new_course(const EvolutionRun& run, const EvolutionKinds& kinds) {
    const Result<SettingsPtr> settings = settings_of(run, kinds);
    if (!settings) return settings.error();
    for (const std::string& warning : setting_warnings(**settings, kinds))
        say(warning);
    const auto given = founders_of({run.founders, run.museum}, **settings, kinds);
    if (!given) return given.error();
    const std::vector<GenomePtr>& founders = *given;
    Result<RunOutputs> outputs = run_outputs({run.out, **settings, files_of(run)});
    if (!outputs) return outputs.error();
    StartedFile made;
    std::shared_ptr<ExperimentFile> file;
    if (!outputs->experiment.empty()) {
        auto created = ExperimentFile::create(kinds, *settings, founders);
        if (!created) return created.error();
        file = *created;
        outputs = take_names(*file, *std::move(outputs), run, **settings);
        if (!outputs) return outputs.error();
        made = StartedFile(outputs->experiment);
    }
    return Course{Evolution(*settings, kinds, founders), **settings, std::move(made),
                  std::move(file), *std::move(outputs)};
}

// Fails if an experiment has already reached its limits.
Status check_unfinished(const std::string& file, const SavedExperiment& saved,
                        const ExperimentSettings& limits) {
    if (!saved.latest || stop_reason(saved.latest->history, limits).empty()) return {};
    return Error{fmt::format("{}: is complete with {} generations; --generations N continues it",
                             file, saved.latest->history.size())};
}

ExperimentSettings limits_of(const EvolutionRun& run, ExperimentSettings limits) {
    if (!run.generations) return limits;
    // Whoever asks for more generations wants them, whatever ended the run before.
    limits.generations = *run.generations;
    limits.max_evaluations = ExperimentSettings().max_evaluations;
    limits.target_fitness = ExperimentSettings().target_fitness;
    return limits;
}

// What is done to an experiment that is continued, before its next generation.
struct Steering {
    std::vector<SteeringCommand> commands;  // without those that would change nothing
    ExperimentSettings settings;            // of the next generation
    std::vector<std::string> words;         // what changes
};

// Takes over the values that were typed.
Status change_settings(Steering& steering, const std::vector<std::string>& sets,
                       std::uint32_t generation, const EvolutionKinds& kinds) {
    ExperimentSettings running = steering.settings;
    Result<ExperimentSettings> typed = with_typed(running, sets, kinds);
    if (!typed) return Error{"--set: " + typed.error().message};
    const std::vector<SettingField> fields = setting_fields(kinds);
    for (const SettingField& field : fields) {
        if (field.by_run || same_value(field, running, *typed)) continue;
        if (!field.live) {
            return Error{
                fmt::format("--set: {} cannot change during a run; a new run can have "
                            "another",
                            path_of(field))};
        }
        steering.words.push_back(fmt::format("{}: {} instead of {} from generation {} on",
                                             path_of(field), value_text(field, field.at(*typed)),
                                             value_text(field, field.at(running)), generation));
    }
    steering.settings = with_live_fields(running, *typed, fields);
    if (const Status valid = check_settings(steering.settings, kinds); !valid)
        return Error{"--set: " + valid.error().message};
    if (!(steering.settings == running))
        steering.commands.emplace_back(
            ChangeSettings{std::make_shared<const ExperimentSettings>(steering.settings)});
    return {};
}

Result<Steering> steering_of(const EvolutionRun& run, const Evolution& evolution,
                             const EvolutionKinds& kinds) {
    Steering steering{{}, evolution.settings(), {}};
    if (!run.sets.empty()) {
        const Status changed = change_settings(steering, run.sets, evolution.generation(), kinds);
        if (!changed) return changed.error();
    }
    const FounderPlaces places = {"[population] size", steering.settings.population.size,
                                  "--inject"};
    const auto files = load_founders(run.injected, places, steering.settings, kinds);
    if (!files) return files.error();
    for (GenomePtr& genome : genomes_of(*files))
        steering.commands.emplace_back(InjectGenome{std::move(genome)});
    return steering;
}

// Returns the experiment file to continue: the given one or, if another output is given, a copy.
Result<std::string> file_to_resume(const EvolutionRun& run, const EvolutionKinds& kinds) {
    if (!is_experiment_name(run.out)) return run.resume;
    const Result<SavedExperiment> saved = load_experiment(run.resume, kinds);
    if (!saved) return saved.error();
    const Evolution evolution = resumed(*saved, kinds);
    const Result<Steering> steering = steering_of(run, evolution, kinds);
    if (!steering) return steering.error();
    const ExperimentSettings limits = limits_of(run, steering->settings);
    if (Status unfinished = check_unfinished(run.resume, *saved, limits); !unfinished)
        return unfinished.error();
    if (Status copied = copy_experiment(run.resume, run.out); !copied) return copied.error();
    return run.out;
}

Result<Course> resumed_course(const EvolutionRun& run, const EvolutionKinds& kinds) {
    const Result<std::string> file = file_to_resume(run, kinds);
    if (!file) return file.error();
    StartedFile made;
    if (*file != run.resume) made = StartedFile(*file);
    Result<OpenedExperiment> opened = open_experiment(*file, kinds);
    if (!opened) return opened.error();
    const SavedExperiment& saved = opened->saved;
    say_of_simulator(run.resume, saved);
    Evolution evolution = resumed(saved, kinds);
    const Result<Steering> steering = steering_of(run, evolution, kinds);
    if (!steering) return steering.error();
    ExperimentSettings limits = limits_of(run, steering->settings);
    if (Status unfinished = check_unfinished(run.resume, saved, limits); !unfinished)
        return unfinished.error();
    Result<RunOutputs> outputs =
        run.out.empty() ? RunOutputs{} : run_outputs({run.out, limits, files_of(run)});
    if (!outputs) return outputs.error();
    outputs->experiment = *file;
    std::vector<NotedCommand> notes;
    for (const std::string& each : steering->words)
        say(each);
    for (const SteeringCommand& command : steering->commands) {
        notes.push_back({evolution.generation(), command});
        if (Status noted = opened->file->note(notes.back()); !noted) return noted.error();
    }
    give_commands(evolution, notes);
    return Course{std::move(evolution),    std::move(limits),   std::move(made),
                  std::move(opened->file), *std::move(outputs), std::move(opened->saved)};
}

Result<Course> course_of(const EvolutionRun& run, const EvolutionKinds& kinds) {
    if (!run.resume.empty()) return resumed_course(run, kinds);
    if (run.settings_file.empty()) return Error{no_settings_file(run.founders)};
    return new_course(run, kinds);
}

// The result of an evolution.
struct Harvest {
    // Of the last generation saved: audited unless that was interrupted, in which case it is the
    // best by score.
    std::optional<JudgedIndividual> champion;
    std::string_view stopped_by;  // a stop_reason(), "interruption" or "failure"
    Status kept;
    Status told;  // whether standard output could be written
};

// Prints a line for each generation; with a cluster, it says who took part.
class GenerationReport {
public:
    // All arguments must outlive the object.
    GenerationReport(const EvaluationBackend& backend, const ReportedRun& run)
        : backend_(backend), run_(run) {}

    std::string line(const GenerationStatistics& statistics) {
        const BackendStatus status = backend_.status();
        std::string cluster;
        if (status.link != ClusterLink::kNone) cluster = cluster_json(status, before_);
        before_ = status.counts;
        return generation_line(statistics, run_, cluster);
    }

private:
    const EvaluationBackend& backend_;
    const ReportedRun& run_;
    BackendCounts before_;
};

// Makes the audited champion, if there is one, the run's and the file's.
void crown(Harvest& harvest, Course& course, const std::optional<IndividualPtr>& audited) {
    if (!audited) return;
    harvest.champion->individual = *audited;
    if (course.file) harvest.kept = course.file->crown(*harvest.champion);
}

// Evaluates, saves and breeds generations until the run ends.
Harvest evolve(Course& course, EvaluationBackend& backend, const ReportedRun& run) {
    Harvest harvest;
    const Interruption interruption;
    EvaluationProgress progress;
    Evolution& evolution = course.evolution;
    ProgressBar bar(progress, static_cast<std::uint32_t>(course.limits.generations),
                    static_cast<std::uint32_t>(evolution.history().size()),
                    [&backend] { return cluster_remark(backend.status()); });
    const ClusterWatch watch(backend, [&bar](std::string_view words) { bar.say_above(words); });
    GenerationReport report(backend, run);
    course.made.keep();  // all threads have started
    for (;;) {
        if (!evolution.evaluate(backend, progress, interruption.token())) {
            const bool asked = interruption.requested();
            harvest.stopped_by = asked ? "interruption" : "failure";
            if (!asked) harvest.kept = Error{backend.status().failure};
            return harvest;
        }
        if (course.file) harvest.kept = course.file->record(evolution);
        if (!harvest.kept) {
            harvest.stopped_by = "failure";
            return harvest;
        }
        harvest.champion = {evolution.generation(), evolution.population().front(),
                            evolution.shared_settings()};
        harvest.told = bar.finish_generation(report.line(evolution.history().back()));
        if (!harvest.told) {
            harvest.stopped_by = "failure";
            return harvest;
        }
        harvest.stopped_by = stop_reason(evolution.history(), course.limits);
        if (harvest.stopped_by.empty() && interruption.requested())
            harvest.stopped_by = "interruption";
        if (!harvest.stopped_by.empty()) {
            crown(harvest, course,
                  evolution.confirmed_champion(backend, progress, interruption.token()));
            return harvest;
        }
        evolution.breed();
    }
}

// Saves the champion and prints the final line.
ExitStatus report(const EvolutionRun& asked, const Course& course, const Harvest& harvest,
                  const ReportedRun& run, const EvolutionKinds& kinds) {
    RunOutputs outputs = course.outputs;
    if (!outputs.champion.empty() || !asked.museum.empty()) {
        CreatureDocument champion = creature_document(*harvest.champion, kinds);
        if (course.before) {
            champion.notes.simulator = scored_by(*course.before, harvest.champion->individual->born,
                                                 harvest.champion->generation);
        }
        complete_score(champion, kinds);
        if (!outputs.champion.empty()) {
            const auto saved = save_champion(outputs, {asked.out, course.limits, files_of(asked)},
                                             champion, kinds);
            if (!saved) return fail(saved.error(), ExitStatus::kFailed);
            outputs.champion = *saved;
        }
        if (const Status shown = exhibit(asked.museum, champion, kinds); !shown)
            return fail(shown.error(), ExitStatus::kFailed);
    }
    if (!harvest.told) return fail(harvest.told.error(), ExitStatus::kFailed);
    const auto& [generation, individual, settings] = *harvest.champion;
    ReportedChampion champion{*individual};
    if (has_chance(settings->world))
        champion.held_out = held_out_score(individual->genome, *settings, kinds);
    return print_result_line(
        final_line(course.evolution, run, champion, outputs, harvest.stopped_by));
}

void say_how_to_go_on(const Course& course) {
    if (!course.file) return;
    const int limit = course.evolution.settings().generations;
    say(fmt::format("to continue: cambrian evolve --resume {}{}",
                    shell_word(course.outputs.experiment.string()),
                    course.limits.generations == limit
                        ? ""
                        : fmt::format(" --generations {}", course.limits.generations)));
}

// The end of a run.
struct RunEnd {
    ExitStatus status = ExitStatus::kDone;
    bool interrupted = false;
};

// Returns the address of the cluster that the options name, if any; fails if it cannot be used.
Result<std::optional<ClusterAddress>> cluster_of(const EvolutionRun& run) {
    if (run.cluster.servers.empty()) return std::optional<ClusterAddress>();
    Result<ClusterAddress> address = usable_cluster(run.cluster);
    if (!address) return address.error();
    return std::optional(*std::move(address));
}

Result<std::unique_ptr<EvaluationBackend>> backend_of(const EvolutionRun& run,
                                                      const std::optional<ClusterAddress>& cluster,
                                                      const RunOutputs& outputs,
                                                      const EvolutionKinds& kinds) {
    const std::size_t threads = run.threads.value_or(ThreadPool::default_workers());
    if (!cluster) return make_thread_pool_backend(kinds, threads);
    return join_cluster(kinds, *cluster,
                        {.threads = {.workers = threads, .priority = ThreadPriority::kNormal},
                         .experiment = outputs.experiment});
}

// Runs one evolution, with the first of the seeds if there are any.
RunEnd run_once(const EvolutionRun& run, const EvolutionKinds& kinds) {
    // This must fail before any file is written.
    const auto cluster = cluster_of(run);
    if (!cluster) return {fail(cluster.error())};
    if (*cluster && kinds.creature.scene.dimensions == 3)
        return {fail({"clusters are not built in three dimensions yet"})};
    Result<Course> course = course_of(run, kinds);
    if (!course) return {fail(course.error())};
    const auto backend = backend_of(run, *cluster, course->outputs, kinds);
    if (!backend) return {fail(backend.error())};
    if (run.resume.empty() || !run.out.empty()) say(words_of(course->outputs));
    const ReportedRun reported{course->limits.seed, kinds.goals.find(course->limits.goal)->unit,
                               run.json};
    const Harvest harvest = evolve(*course, **backend, reported);
    ExitStatus status = ExitStatus::kFailed;
    if (harvest.champion) {
        status = report(run, *course, harvest, reported, kinds);
    } else if (harvest.kept) {
        const bool first = course->evolution.history().empty();
        say(fmt::format("interrupted before the {} generation was judged",
                        first ? "first" : "next"));
    }
    if (!harvest.kept) status = fail(harvest.kept.error(), ExitStatus::kFailed);
    if (harvest.stopped_by == "interruption" || harvest.stopped_by == "failure")
        say_how_to_go_on(*course);
    return {status, harvest.stopped_by == "interruption"};
}

// Several runs need a folder, since their files are named after their seeds.
Status check_place_of_several(const EvolutionRun& run) {
    const bool folder =
        run.out.empty() || run.out.ends_with('/') || std::filesystem::is_directory(run.out);
    if (folder) return {};
    return Error{
        fmt::format("--out {}: several seeds need a folder; {}/ makes one", run.out, run.out)};
}

}  // namespace

CommandFiles files_of(const EvolutionRun& run) {
    CommandFiles files;
    files.reads(run.settings_file)
        .reads(run.resume)
        .reads_each(run.founders)
        .reads_each(run.injected)
        .fills(run.museum);
    add_login_files(files, run.cluster);
    return is_experiment_name(run.out) ? files.keeps(run.out) : files.writes(run.out);
}

ExitStatus run_evolution(const EvolutionRun& run, const EvolutionKinds& kinds) {
    if (run.seeds.size() < 2) return run_once(run, kinds).status;
    if (const Status place = check_place_of_several(run); !place) return fail(place.error());
    ExitStatus worst = ExitStatus::kDone;
    for (const std::uint64_t seed : run.seeds) {
        EvolutionRun one = run;
        one.seeds = {seed};
        const RunEnd end = run_once(one, kinds);
        worst = std::max(worst, end.status);
        if (end.interrupted || end.status == ExitStatus::kBadInput) break;
    }
    return worst;
}

}  // namespace cambrian
