#include "app/evolve/experiment_rescoring.h"

#include "persist/creature/rescoring.h"

#include <algorithm>

namespace cambrian {
namespace {

std::optional<double> score_of(std::uint64_t uid, const std::vector<IndividualPtr>& population) {
    const auto found = std::find_if(population.begin(), population.end(),
                                    [uid](const IndividualPtr& each) { return each->uid == uid; });
    if (found == population.end()) return std::nullopt;
    return unconfirmed_score((*found)->result);
}

}  // namespace

Result<std::optional<RescoredExperiment>> rescore_experiment(const std::filesystem::path& path,
                                                             const EvolutionKinds& kinds,
                                                             EvaluationBackend& backend,
                                                             const std::stop_token& stop) {
    const Result<OpenedExperiment> opened = open_experiment(path, kinds);
    if (!opened) return opened.error();
    const SavedExperiment& saved = opened->saved;
    if (!saved.latest) return Error{path.string() + ": no generation has been finished yet"};
    if (!other_simulator(saved)) return std::optional<RescoredExperiment>();
    Evolution evolution = resumed(saved, kinds);
    evolution.rescore();
    EvaluationProgress progress;
    if (!evolution.evaluate(backend, progress, stop))
        return Error{path.string() + ": left as it is: interrupted"};
    ExperimentFile& file = *opened->file;
    if (const Status noted = file.note({evolution.generation(), RescorePopulation{}}); !noted)
        return noted.error();
    if (const Status kept = file.record(evolution); !kept) return kept.error();
    const JudgedIndividual& before = saved.champions.back();
    return std::optional(
        RescoredExperiment{.simulator = saved.simulators.back().version,
                           .before = before,
                           .again = score_of(before.individual->uid, evolution.population()),
                           .after = {evolution.generation(), evolution.population().front(),
                                     evolution.shared_settings()}});
}

}  // namespace cambrian
