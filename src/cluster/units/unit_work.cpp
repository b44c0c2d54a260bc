#include "cluster/units/unit_work.h"

#include "core/thread_time.h"
#include "evolution/evaluation/trials.h"

#include <utility>

namespace cambrian {

UnitResult compute_unit(const Unit& unit, const ExperimentSettings& settings,
                        const EvolutionKinds& kinds, const std::stop_token& stop) {
    UnitResult all;
    ThreadTimer timer;
    for (const EvaluationRequest& request : unit.requests) {
        if (stop.stop_requested()) break;
        EvaluationResult result = evaluate_in_trials(request, settings, kinds, stop);
        if (result.outcome == Outcome::kInterrupted) break;
        all.results.push_back({request.slot, genome_hash(*request.genome), std::move(result)});
    }
    all.seconds = timer.lap();
    return all;
}

}  // namespace cambrian
