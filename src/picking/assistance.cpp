#include "picking/assistance.h"

#include "picking/grid/grid_breeding.h"
#include "picking/handover.h"

namespace cambrian {
namespace {

SettingsPtr assisted_settings(const ExperimentSettings& settings, std::uint32_t node) {
    auto assisted = std::make_shared<ExperimentSettings>(settings);
    assisted->seed = stream_seed({picking_seed(settings), node});
    assisted->population.size = kAssistedPopulation;
    assisted->population.fill = "mutants";
    assisted->terminate_early = false;  // people look at creatures that selection would not keep
    return assisted;
}

}  // namespace

Assistance::Assistance(std::span<const IndividualPtr> picks, int generations, std::uint32_t node,
                       const ExperimentSettings& settings, const EvolutionKinds& kinds)
    : generations_(generations),
      evolution_(assisted_settings(settings, node), kinds, genomes_of(picks)) {
    CAMBRIAN_ASSERT(!picks.empty(), "there is something to start from");
}

bool Assistance::step(EvaluationBackend& backend, EvaluationProgress& progress,
                      const std::stop_token& stop) {
    if (evolution_.evaluated()) evolution_.breed();
    if (!evolution_.evaluate(backend, progress, stop)) return false;
    done_ = static_cast<int>(evolution_.generation());
    return true;
}

std::vector<IndividualPtr> Assistance::elites() const {
    std::vector<IndividualPtr> elites = evolution_.population();
    elites.resize((elites.size() + 1) / 2);
    if (evolution_.settings().world.trial.trials == 1) return elites;
    for (IndividualPtr& elite : elites)
        elite = without_score(*elite);
    return elites;
}

}  // namespace cambrian
