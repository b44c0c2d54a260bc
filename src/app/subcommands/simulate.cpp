#include "app/messages.h"
#include "app/motion_trace.h"
#include "app/output_path.h"
#include "app/subcommands/subcommands.h"
#include "core/file_io.h"
#include "core/number_text.h"
#include "evolution/setting_field.h"
#include "evolution/trials.h"
#include "persist/creature_file.h"
#include "persist/digest_text.h"
#include "persist/quoted_text.h"
#include "persist/settings_file.h"

#include <CLI/CLI.hpp>

#include <optional>

namespace cambrian {
namespace {

struct SimulateOptions {
    std::string creature;
    std::string environment;
    std::string trace;
    std::optional<double> seconds;
    bool json = false;
};

// The world the creature is put in: a settings file's, or the one it was scored in.
Result<ExperimentSettings> world_of(const SimulateOptions& options,
                                    const CreatureDocument& document, const EvolutionKinds& kinds) {
    Result<ExperimentSettings> settings =
        document.scored ? settings_of(*document.scored) : ExperimentSettings{};
    if (!options.environment.empty()) settings = load_settings(options.environment, kinds);
    if (!settings) return settings.error();
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

std::string report(const EvaluationResult& result, const std::string& unit, bool json) {
    const std::string outcome(outcome_name(result.outcome));
    if (json) {
        return "{\"outcome\": " + quoted_text(outcome) +
               ", \"reason\": " + quoted_text(result.reason) +
               ", \"fitness\": " + real_text(result.fitness) + ", \"unit\": " + quoted_text(unit) +
               ", \"body_length\": " + real_text(result.body_length) +
               ", \"mass\": " + real_text(result.mass) +
               ", \"parts\": " + std::to_string(result.parts) +
               ", \"neurons\": " + std::to_string(result.neurons) +
               ", \"trajectory\": " + quoted_text(digest_text(result.digest)) + "}";
    }
    return outcome + (result.reason.empty() ? "" : " (" + result.reason + ")") + ": " +
           short_text(result.fitness) + " " + unit + "\n" + std::to_string(result.parts) +
           " parts, " + std::to_string(result.neurons) + " neurons at work, " +
           short_text(result.body_length) + " m long, " + short_text(result.mass) + " kg\nmotion " +
           digest_text(result.digest);
}

class SimulateSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("creature", options_.creature, "Creature file (*.creature.json)")
            ->required();
        app.add_option("-e,--environment", options_.environment,
                       "Settings file whose world and goal to use instead of the creature's own");
        app.add_option("--seconds", options_.seconds, "Length of the trial, instead of its own");
        app.add_option("--trace", options_.trace,
                       "Write every part's motion to this file, as CSV with a row a tick");
        app.add_flag("--json", options_.json, "Report as one JSON object");
    }
    ExitStatus run(const EvolutionKinds& kinds) override {
        const Result<CreatureDocument> document = load_creature(options_.creature, kinds);
        if (!document) return fail(document.error());
        for (const std::string& warning : document->warnings)
            say(options_.creature + ": " + warning);
        const Result<ExperimentSettings> settings = world_of(options_, *document, kinds);
        if (!settings) return fail(settings.error());
        const auto genome = std::make_shared<const Genome>(document->genome);
        if (!options_.trace.empty()) {
            const ExitStatus traced = write_trace(genome, *settings, kinds.creature);
            if (traced != ExitStatus::kDone) return traced;
        }
        const EvaluationResult result = evaluate_in_trials(
            {.genome = genome, .trial_seed = trial_seed(*settings)}, *settings, kinds);
        print_line(report(result, kinds.goals.find(settings->goal)->unit, options_.json));
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
