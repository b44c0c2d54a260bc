#include "app/messages.h"
#include "app/subcommands/subcommands.h"
#include "core/number_text.h"
#include "evolution/trials.h"
#include "persist/creature_file.h"
#include "persist/digest_text.h"

#include <CLI/CLI.hpp>

namespace cambrian {
namespace {

// The trial of the file, run again here and now.
EvaluationResult replay(const CreatureDocument& document, const EvolutionKinds& kinds) {
    const auto genome = std::make_shared<const Genome>(document.genome);
    const ExperimentSettings settings = settings_of(*document.scored);
    return evaluate_in_trials({.genome = genome, .trial_seed = trial_seed(settings)}, settings,
                              kinds);
}

ExitStatus verify(const std::string& file, const EvolutionKinds& kinds) {
    const Result<CreatureDocument> document = load_creature(file, kinds);
    if (!document) return fail(document.error());
    for (const std::string& warning : document->warnings)
        say(file + ": " + warning);
    if (!document->scored) return fail({file + ": holds no score to verify"});
    const ScoredRecord& scored = *document->scored;
    const EvaluationResult result = replay(*document, kinds);
    if (result.digest == scored.trajectory && result.fitness == scored.fitness) {
        print_line(file + ": replay verified, " + short_text(result.fitness) + " " + scored.unit);
        return ExitStatus::kDone;
    }
    std::string message = file + ": the replay differs: " + short_text(result.fitness) + " " +
                          scored.unit + " with motion " + digest_text(result.digest) +
                          " instead of " + short_text(scored.fitness) + " with " +
                          digest_text(scored.trajectory);
    if (scored.simulator != kSimulatorVersion) {
        message += "; it was scored by simulator " + scored.simulator + ", this is " +
                   std::string(kSimulatorVersion);
    }
    return fail({message}, ExitStatus::kFailed);
}

class VerifySubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("creatures", files_, "Creature files (*.creature.json)")->required();
    }
    ExitStatus run(const EvolutionKinds& kinds) override {
        ExitStatus worst = ExitStatus::kDone;
        for (const std::string& file : files_)
            worst = std::max(worst, verify(file, kinds));
        return worst;
    }

private:
    std::vector<std::string> files_;
};

}  // namespace

SubcommandKind verify_subcommand() {
    return {.id = "verify",
            .summary = "Run the trial that scored a creature again and compare every bit.",
            .example = "cambrian verify champion-walking-seed7.creature.json",
            .make = []() -> std::unique_ptr<Subcommand> {
                return std::make_unique<VerifySubcommand>();
            }};
}

}  // namespace cambrian
