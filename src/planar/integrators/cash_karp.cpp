// J. R. Cash, A. H. Karp, A variable order Runge-Kutta method for initial value problems with
// rapidly varying right-hand sides, ACM Trans. Math. Softw. 16 (1990): 5(4) with six stages, and a
// seventh at the step's end, which the next step and the dense output need.

#include "planar/integrators/builtin_integrators.h"
#include "planar/integrators/embedded_runge_kutta.h"

namespace cambrian {
namespace {

struct CashKarp {
    static constexpr std::size_t kStages = 7;
    static constexpr double kNodes[7] = {0.0, 1.0 / 5, 3.0 / 10, 3.0 / 5, 1.0, 7.0 / 8, 1.0};
    static constexpr double kRows[7][6] = {
        {},
        {1.0 / 5},
        {3.0 / 40, 9.0 / 40},
        {3.0 / 10, -9.0 / 10, 6.0 / 5},
        {-11.0 / 54, 5.0 / 2, -70.0 / 27, 35.0 / 27},
        {1631.0 / 55296, 175.0 / 512, 575.0 / 13824, 44275.0 / 110592, 253.0 / 4096},
        {37.0 / 378, 0.0, 250.0 / 621, 125.0 / 594, 0.0, 512.0 / 1771}};
    static constexpr double kErrors[7] = {37.0 / 378 - 2825.0 / 27648,
                                          0.0,
                                          250.0 / 621 - 18575.0 / 48384,
                                          125.0 / 594 - 13525.0 / 55296,
                                          -277.0 / 14336,
                                          512.0 / 1771 - 1.0 / 4,
                                          0.0};
};

void attempt_cash_karp_step(const MotionSystem& system, const StepRequest& request,
                            EvaluationCache& cache, StepResult& result) {
    EmbeddedStep<CashKarp>(system, request, cache, result).attempt();
}

}  // namespace

void add_cash_karp(IntegratorRegistry& integrators) {
    integrators.add({"cash-karp", "Cash-Karp", attempt_cash_karp_step, 5, 1.0 / 60, true});
}

}  // namespace cambrian
