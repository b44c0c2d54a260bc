#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "app/trial/creature_world.h"
#include "app/trial/motion_trace.h"
#include "app/trial/score_notice.h"
#include "app/trial/sense_report.h"
#include "app/trial/trial_report.h"
#include "core/files/output_stream.h"
#include "core/text/number_text.h"
#include "evolution/evaluation/evaluation.h"
#include "evolution/evaluation/trials.h"
#include "evolution/fields/setting_field.h"
#include "persist/creature/creature_file.h"
#include "persist/settings/typed_setting.h"

#include <CLI/CLI.hpp>

#include <optional>

namespace cambrian {
namespace {

struct SimulateOptions {
    std::string creature;
    std::string environment;
    std::string trace;
    std::string integrator;
    std::optional<double> seconds;
    std::optional<double> tolerance;
    std::optional<int> repeat;
    std::optional<int> trial;
    std::vector<std::string> sets;
    bool senses = false;
    bool json = false;
};

// Returns the settings, with the values that the options override.
Result<ExperimentSettings> settings_for(const SimulateOptions& options,
                                        const CreatureDocument& document,
                                        const EvolutionKinds& kinds) {
    Result<ExperimentSettings> settings = world_of(document, options.environment, kinds);
    if (!settings) return settings.error();
    settings = with_typed(*std::move(settings), options.sets, kinds);
    if (!settings) return Error{"--set: " + settings.error().message};
    if (!options.integrator.empty()) settings->world.scene.integrator = options.integrator;
    settings->world.trial.duration = options.seconds.value_or(settings->world.trial.duration);
    settings->world.scene.tolerance = options.tolerance.value_or(settings->world.scene.tolerance);
    if (const Status valid = check_settings(*settings, kinds); !valid) return valid.error();
    return settings;
}

std::string json_of(const EvaluationResult& result, const std::optional<SenseLosses>& losses,
                    const std::string& unit) {
    return trial_json(result, unit, losses ? senses_json(*losses) : "null");
}

std::string text_of(const EvaluationResult& result, const std::optional<SenseLosses>& losses,
                    const std::string& unit) {
    return trial_text(result, unit) + (losses ? "\n" + senses_text(*losses, unit) : "");
}

class SimulateSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("creature", options_.creature,
                       "Creature file (*.creature.json) or card (*.card.png)")
            ->type_name(option_type::kCreature)
            ->required();
        app.add_option(
               "-e,--environment", options_.environment,
               "Settings file whose environment and goal are used instead of the creature's own")
            ->type_name(option_type::kSettings);
        app.add_option("--integrator", options_.integrator,
                       "Integrator instead of the settings' one; 'cambrian settings' lists them");
        take_finite(
            *app.add_option("--seconds", options_.seconds,
                            "Duration of the trial in seconds, instead of the settings' one"));
        take_finite(*app.add_option("--tolerance", options_.tolerance,
                                    "Permitted error of a time step, 1e-8 to 0.1, instead of the "
                                    "settings' one"));
        app.add_option(
               "--set", options_.sets,
               "Value of a setting, as environment.gravity=1.62; may be given several times")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
        take_whole(*app.add_option("--repeat", options_.repeat,
                                   "Number of further trials in slightly different worlds, whose "
                                   "median score and range tell skill from luck; none by default"),
                   1, 1000);
        auto& trace = *app.add_option("--trace", options_.trace,
                                      "File for every part's motion, as CSV with one row per tick "
                                      "(1/60 s)")
                           ->type_name(option_type::kTable);
        take_whole(*app.add_option("--trial", options_.trial,
                                   "Number of the trial whose motion is written, of those that the "
                                   "score combines; the first by default")
                        ->needs(&trace),
                   1, 50);
        app.add_flag(
            "--senses", options_.senses,
            "Score that is left, in trials that no generation uses, if the senses read their "
            "best constants, all together and each alone");
        app.add_flag("--json", options_.json, "Output as one JSON object");
    }
    CommandFiles files() const override {
        return CommandFiles()
            .reads(options_.creature)
            .reads(options_.environment)
            .writes(options_.trace, output_form::kTable);
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        const Result<CreatureDocument> document = load_creature(options_.creature, kinds);
        if (!document) return fail(document.error());
        say_of(options_.creature, document->warnings);
        say_of_simulator(options_.creature, *document);
        const Result<ExperimentSettings> settings = settings_for(options_, *document, kinds);
        if (!settings) return fail(settings.error());
        if (!options_.environment.empty())
            say_of(options_.creature, foreign_kinds(document->genome(), settings->founders, kinds));
        if (const Status known = check_trial(options_.trial, options_.creature, *settings); !known)
            return fail(known.error());
        const GenomePtr& genome = document->creature.individual->genome;
        LongWork work;
        if (!options_.trace.empty()) {
            const ExitStatus traced = write_trace(genome, *settings, kinds.creature, work);
            if (traced != ExitStatus::kDone) return traced;
        }
        work.begin("evaluating", settings->world.trial.duration * settings->world.trial.trials);
        EvaluationResult result = evaluate_in_trials(
            {.genome = genome, .trial_seed = trial_seed(*settings)}, *settings, kinds, work.stop());
        if (result.outcome == Outcome::kCompleted && !result.finer) {
            work.begin("computing more finely", settings->world.trial.duration);
            result.finer = recompute(*genome, *settings, kinds, work.stop());
        }
        if (options_.repeat && result.outcome == Outcome::kCompleted) {
            work.begin("trying again", *options_.repeat, "worlds");
            result.scores = scores_in(probes_of(*settings, 0, *options_.repeat), genome, *settings,
                                      kinds, work.stop());
        }
        std::optional<SenseLosses> losses;
        if (options_.senses && result.outcome == Outcome::kCompleted) {
            work.begin("holding senses", settings->world.trial.duration);
            losses = sense_losses(genome, *settings, kinds, work.stop());
        }
        if (work.interrupted()) return fail({"interrupted"}, ExitStatus::kFailed);
        const std::string& unit = kinds.goals.find(settings->goal)->unit;
        return print_result_line(options_.json ? json_of(result, losses, unit)
                                               : text_of(result, losses, unit));
    }

private:
    ExitStatus write_trace(const GenomePtr& genome, const ExperimentSettings& settings,
                           const Kinds& kinds, LongWork& work) const {
        const auto path = output_path(options_.trace, "trace.csv", files());
        if (!path) return fail(path.error());
        Result<OutputStream> output = OutputStream::open(*path);
        if (!output) return fail(output.error());
        work.begin("tracing", settings.world.trial.duration);
        Status written = write_motion_trace(
            *output, trial_setup(genome, settings, options_.trial.value_or(1) - 1),
            settings.expression, kinds, work.watch());
        if (written) written = output->finish();
        return written ? ExitStatus::kDone : fail(written.error(), ExitStatus::kFailed);
    }

    SimulateOptions options_;
};

}  // namespace

SubcommandKind simulate_subcommand() {
    return {.id = "simulate",
            .summary = "Run one creature's trial: its performance, and its motion if asked.",
            .example = "cambrian simulate champion-walking-seed7.creature.json --trace motion.csv",
            .make = make_subcommand<SimulateSubcommand>};
}

}  // namespace cambrian
