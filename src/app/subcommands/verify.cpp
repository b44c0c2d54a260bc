#include "app/command_line/option_types.h"
#include "app/evolve/experiment_replay.h"
#include "app/preserve/preserve_replay.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "app/trial/score_notice.h"
#include "app/trial/trial_report.h"
#include "core/text/number_text.h"
#include "core/threads/thread_pool.h"
#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evaluation/evaluation.h"
#include "persist/creature/creature_file.h"
#include "persist/creature/rescoring.h"
#include "persist/experiment/experiment_file.h"
#include "persist/preserve/preserve_file.h"
#include "persist/text/digest_text.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace cambrian {
namespace {

// Runs the trial of the file again, also with the finer step if the file has that result.
EvaluationResult replay(const CreatureDocument& document, const EvolutionKinds& kinds,
                        LongWork& work) {
    const TrialSettings& trial = document.settings().world.trial;
    work.begin("replaying", trial.duration * trial.trials);
    EvaluationResult result = run_scored_trial(document, kinds, work.stop());
    if (document.result().finer && !result.finer) {
        work.begin("computing more finely", trial.duration);
        result.finer = recompute(document.genome(), document.settings(), kinds, work.stop());
    }
    return result;
}

// Returns the time at which the motion begins to differ, if the file has check bytes.
std::string where_different(const CreatureDocument& document, const EvolutionKinds& kinds) {
    const TickChecks& ticks = document.notes.ticks;
    if (ticks.empty()) return {};
    const auto noted = note_ticks(document.genome(), document.settings(), kinds);
    if (!noted) return " before its first tick";
    const auto tick = first_different_tick(noted->ticks, ticks);
    if (tick) return fmt::format(" from tick {} on", *tick);
    return noted->ticks.size() == kMostTickChecks
               ? fmt::format(" after tick {}", kMostTickChecks)
               : std::string(", though the motion of the first trial does not");
}

ExitStatus verify(const std::string& file, const EvolutionKinds& kinds, LongWork& work) {
    const Result<CreatureDocument> document = load_creature(file, kinds);
    if (!document) return fail(document.error());
    say_of(file, document->warnings);
    if (!document->scored()) return fail({file + ": holds no score to verify"});
    const EvaluationResult& scored = document->result();
    const std::string& unit = document->notes.unit;
    say_of_simulator(file, *document);
    const EvaluationResult result = replay(*document, kinds, work);
    if (work.interrupted()) return fail({file + ": interrupted"}, ExitStatus::kFailed);
    if (result.digest == scored.digest && result.fitness == document->score()) {
        if (scored.finer && result.finer != scored.finer)
            return fail(
                {fmt::format("{}: computed more finely it differs: {} instead of {}", file,
                             finer_text(*result.finer, unit), finer_text(*scored.finer, unit))},
                ExitStatus::kFailed);
        std::string message =
            fmt::format("{}: replay verified, {} {}, {}", file, short_text(result.fitness), unit,
                        verdict_name(result.verdict));
        if (scored.finer) message += "; computed more finely " + finer_text(*scored.finer, unit);
        return print_result_line(message);
    }
    std::string message = fmt::format(
        "{}: the replay differs{}: {} {} with motion {} instead of {} with {}", file,
        where_different(*document, kinds), short_text(result.fitness), unit,
        digest_text(result.digest), short_text(document->score()), digest_text(scored.digest));
    return fail({message}, ExitStatus::kFailed);
}

// Example: "; from generation 12 on it was computed by simulator 0.9, this is 1.0".
std::string other_simulators(const SavedExperiment& saved) {
    const std::string_view present =
        simulator_version(saved.settings->world.environment.dimensions);
    std::string words;
    for (const SimulatorChange& change : saved.simulators) {
        if (change.version == present) continue;
        words += fmt::format("; from generation {} on it was computed by simulator {}",
                             change.generation, change.version);
    }
    return words.empty() ? words : fmt::format("{}, this is {}", words, present);
}

ExitStatus verify_experiment(const std::string& file, const EvolutionKinds& kinds, LongWork& work) {
    const Result<SavedExperiment> saved = load_experiment(file, kinds);
    if (!saved) return fail(saved.error());
    const auto backend = make_thread_pool_backend(kinds, ThreadPool::default_workers());
    work.begin("replaying", static_cast<double>(saved->digests.size()), "generations");
    const ReplayOutcome outcome = replay_experiment(*saved, kinds, *backend, work.watch());
    const std::string done =
        fmt::format("{} of {} generations", outcome.generations, saved->digests.size());
    if (outcome.different) {
        return fail({fmt::format("{}: the replay differs from generation {} on{}", file,
                                 *outcome.different, other_simulators(*saved))},
                    ExitStatus::kFailed);
    }
    if (outcome.stopped)
        return fail({fmt::format("{}: stopped after {}", file, done)}, ExitStatus::kFailed);
    return print_result_line(fmt::format("{}: replay verified, {}, {} commands on the way", file,
                                         done, saved->journal.size()));
}

ExitStatus verify_one(const std::string& file, const EvolutionKinds& kinds, LongWork& work) {
    if (!is_experiment_name(file)) return verify(file, kinds, work);
    return is_preserve_file(file) ? verify_preserve(file, kinds, work)
                                  : verify_experiment(file, kinds, work);
}

class VerifySubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("creatures", files_,
                       "Creature files, experiment files and preserve files to compute again")
            ->type_name(option_type::kCreatureOrExperiment)
            ->required();
    }
    CommandFiles files() const override { return CommandFiles().reads_each(files_); }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        ExitStatus worst = ExitStatus::kDone;
        LongWork work;
        for (const std::string& file : files_) {
            worst = std::max(worst, verify_one(file, kinds, work));
            if (work.interrupted()) break;
        }
        return worst;
    }

private:
    std::vector<std::string> files_;
};

}  // namespace

SubcommandKind verify_subcommand() {
    return {
        .id = "verify",
        .summary =
            "Run the trial that scored a creature, or a complete experiment or preserve, again; "
            "compare every bit.",
        .example = "cambrian verify champion-walking-seed7.creature.json",
        .make = make_subcommand<VerifySubcommand>};
}

}  // namespace cambrian
