// P. Bogacki, L. F. Shampine, A 3(2) pair of Runge-Kutta formulas, Appl. Math. Lett. 2 (1989).

#include "dynamics/integrators/builtin_integrators.h"
#include "dynamics/integrators/embedded_runge_kutta.h"

namespace cambrian {
namespace {

struct BogackiShampine {
    static constexpr std::size_t kStages = 4;
    static constexpr double kNodes[4] = {0.0, 1.0 / 2, 3.0 / 4, 1.0};
    static constexpr double kRows[4][3] = {
        {0.0, 0.0, 0.0}, {1.0 / 2, 0.0, 0.0}, {0.0, 3.0 / 4, 0.0}, {2.0 / 9, 1.0 / 3, 4.0 / 9}};
    static constexpr double kErrors[4] = {-5.0 / 72, 1.0 / 12, 1.0 / 9, -1.0 / 8};
};

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
