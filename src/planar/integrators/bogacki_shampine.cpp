// P. Bogacki, L. F. Shampine, A 3(2) pair of Runge-Kutta formulas, Appl. Math. Lett. 2 (1989).

#include "dynamics/tableaus.h"
#include "planar/integrators/builtin_integrators.h"
#include "planar/integrators/embedded_runge_kutta.h"

namespace cambrian {
namespace {

struct BogackiShampine : tableau::BogackiShampine {};

void attempt_bogacki_shampine_step(const MotionSystem& system, const StepRequest& request,
                                   EvaluationCache& cache, StepResult& result) {
    EmbeddedStep<BogackiShampine>(system, request, cache, result).attempt();
}

}  // namespace

void add_bogacki_shampine(IntegratorRegistry& integrators) {
    integrators.add(
        {"bogacki-shampine", "Bogacki-Shampine", attempt_bogacki_shampine_step, 3, 1.0 / 60, true});
}

}  // namespace cambrian
