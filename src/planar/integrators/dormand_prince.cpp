// J. R. Dormand, P. J. Prince, A family of embedded Runge-Kutta formulae, J. Comput. Appl. Math. 6
// (1980): 5(4) with seven stages.

#include "dynamics/tableaus.h"
#include "planar/integrators/builtin_integrators.h"
#include "planar/integrators/embedded_runge_kutta.h"

namespace cambrian {
namespace {

struct DormandPrince : tableau::DormandPrince {};

void attempt_dormand_prince_step(const MotionSystem& system, const StepRequest& request,
                                 EvaluationCache& cache, StepResult& result) {
    EmbeddedStep<DormandPrince>(system, request, cache, result).attempt();
}

}  // namespace

void add_dormand_prince(IntegratorRegistry& integrators) {
    integrators.add(
        {"dormand-prince", "Dormand-Prince", attempt_dormand_prince_step, 5, 1.0 / 60, true});
}

}  // namespace cambrian
