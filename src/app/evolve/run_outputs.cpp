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
            .experiment = folder / (numbered + ".cambrian")};
}

// Whether neither a name nor anything that is there tells what kind of file is wanted.
bool tells_nothing(const std::string& asked) {
    std::error_code unknown;
    return !asked.empty() && asked.back() != '/' &&
           std::filesystem::path(asked).extension().empty() &&
           !std::filesystem::exists(std::filesystem::symlink_status(asked, unknown));
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
    if (tells_nothing(asked))
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

}  // namespace cambrian
