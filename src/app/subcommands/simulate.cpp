#include "app/creature_world.h"
#include "app/messages.h"
#include "app/motion_trace.h"
#include "app/option_types.h"
#include "app/output_path.h"
#include "app/score_notice.h"
#include "app/subcommands/subcommands.h"
#include "app/trial_report.h"
#include "core/file_io.h"
#include "core/number_text.h"
#include "evolution/evaluation.h"
#include "evolution/setting_field.h"
#include "evolution/trials.h"
#include "persist/creature_file.h"

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
    bool json = false;
};

// What the options say besides the world.
Result<ExperimentSettings> settings_for(const SimulateOptions& options,
                                        const CreatureDocument& document,
                                        const EvolutionKinds& kinds) {
    Result<ExperimentSettings> settings = world_of(document, options.environment, kinds);
    if (!settings) return settings.error();
    if (!options.integrator.empty()) settings->world.scene.integrator = options.integrator;
    settings->world.trial.duration = options.seconds.value_or(settings->world.trial.duration);
    if (const Status valid = check_settings(*settings, kinds); !valid) return valid.error();
    return settings;
}

Result<std::string> trace_of(const GenomePtr& genome, const ExperimentSettings& settings,
                             const Kinds& kinds) {
    const auto phenotype = std::make_shared<const Phenotype>(
        express(*genome, kinds, settings.expression, settings.world.scene));
    auto trial = Trial::start(phenotype, kinds, settings.world);
    if (!trial) return trial.error();
    while ((*trial)->settling() && (*trial)->tick()) {
    }
    MotionTrace trace(**trial);
    trace.add(**trial);
    for (bool more = !(*trial)->finished(); more;) {
        more = (*trial)->tick();
        trace.add(**trial);
    }
    return trace.csv();
}

class SimulateSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("creature", options_.creature, "Creature file (*.creature.json)")
            ->type_name(option_type::kCreature)
            ->required();
        app.add_option("-e,--environment", options_.environment,
                       "Settings file whose world and goal to use instead of the creature's own")
            ->type_name(option_type::kSettings);
        app.add_option("--integrator", options_.integrator,
                       "Integrator to use instead of the world's; 'cambrian settings' lists them");
        app.add_option("--seconds", options_.seconds, "Length of the trial, instead of its own");
        app.add_option("--trace", options_.trace,
                       "Write every part's motion to this file, as CSV with a row a tick")
            ->type_name(option_type::kTable);
        app.add_flag("--json", options_.json, "Report as one JSON object");
    }
    ExitStatus run(const EvolutionKinds& kinds) override {
        const Result<CreatureDocument> document = load_creature(options_.creature, kinds);
        if (!document) return fail(document.error());
        say_of(options_.creature, document->warnings);
        say_of_simulator(options_.creature, *document);
        const Result<ExperimentSettings> settings = settings_for(options_, *document, kinds);
        if (!settings) return fail(settings.error());
        if (!options_.environment.empty())
            say_of(options_.creature, foreign_kinds(document->genome, settings->founders, kinds));
        const auto genome = std::make_shared<const Genome>(document->genome);
        if (!options_.trace.empty()) {
            const ExitStatus traced = write_trace(genome, *settings, kinds.creature);
            if (traced != ExitStatus::kDone) return traced;
        }
        EvaluationResult result = evaluate_in_trials(
            {.genome = genome, .trial_seed = trial_seed(*settings)}, *settings, kinds);
        if (result.outcome == Outcome::kCompleted && !result.finer)
            result.finer = recompute(*genome, *settings, kinds);
        const std::string& unit = kinds.goals.find(settings->goal)->unit;
        print_line(options_.json ? trial_json(result, unit) : trial_text(result, unit));
        return ExitStatus::kDone;
    }

private:
    ExitStatus write_trace(const GenomePtr& genome, const ExperimentSettings& settings,
                           const Kinds& kinds) const {
        const auto path = output_path(options_.trace, "trace.csv");
        if (!path) return fail(path.error());
        const Result<std::string> csv = trace_of(genome, settings, kinds);
        if (!csv) return fail(csv.error(), ExitStatus::kFailed);
        const Status written = write_file(*path, *csv);
        return written ? ExitStatus::kDone : fail(written.error(), ExitStatus::kFailed);
    }

    SimulateOptions options_;
};

}  // namespace

SubcommandKind simulate_subcommand() {
    return {.id = "simulate",
            .summary = "Run one creature's trial: its performance, and its motion if asked.",
            .example = "cambrian simulate champion-walking-seed7.creature.json --trace motion.csv",
            .make = []() -> std::unique_ptr<Subcommand> {
                return std::make_unique<SimulateSubcommand>();
            }};
}

}  // namespace cambrian
