#include "app/evolve/run_outputs.h"

#include "app/command_line/output_path.h"

#include <fmt/core.h>

#include <system_error>

namespace cambrian {
namespace {

constexpr int kMostOfOneName = 10'000;

// Returns the names of a run's files in a folder. The names of run 1 have no number.
RunOutputs named_in(const std::filesystem::path& folder, const std::string& name, int number) {
    const std::string numbered = number == 1 ? name : fmt::format("{}-{}", name, number);
    return {.champion = folder / fmt::format("champion-{}.creature.json", numbered),
            .experiment = folder / (numbered + ".cambrian"),
            .numbered = true};
}

bool is_free(const RunOutputs& outputs) {
    std::error_code unknown;
    return !std::filesystem::exists(outputs.champion, unknown) &&
           !std::filesystem::exists(outputs.experiment, unknown);
}

}  // namespace

Result<RunOutputs> run_outputs(const std::string& asked, const ExperimentSettings& settings,
                               const CommandFiles& files) {
    if (is_experiment_name(asked)) return RunOutputs{.champion = {}, .experiment = asked};
    if (!asked.empty() && !check_ending(asked, output_form::kCreature))
        return Error{
            fmt::format("--out {0}: expected a folder ({0}/), an experiment ({0}.cambrian) "
                        "or a creature file ({0}.creature.json)",
                        asked)};
    const std::string name = fmt::format("{}-seed{}", settings.goal, settings.seed);
    const auto place = output_path(asked, fmt::format("champion-{}.creature.json", name), files);
    if (!place) return place.error();
    if (!asked.empty() && place->string() == asked)
        return RunOutputs{.champion = *place, .experiment = {}};
    RunOutputs outputs;
    int number = 0;
    do {
        outputs = named_in(place->parent_path(), name, ++number);
    } while (!is_free(outputs) && number < kMostOfOneName);
    return outputs;
}

std::string words_of(const RunOutputs& outputs) {
    if (outputs.champion.empty())
        return fmt::format("writes the experiment to {}", outputs.experiment.string());
    if (outputs.experiment.empty())
        return fmt::format(
            "writes the champion to {}, and no experiment; --out FOLDER/ or --out NAME.cambrian "
            "keeps one",
            outputs.champion.string());
    return fmt::format("writes the experiment to {} and the champion to {}",
                       outputs.experiment.string(), outputs.champion.string());
}

}  // namespace cambrian
