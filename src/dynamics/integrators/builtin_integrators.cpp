#include "dynamics/integrators/builtin_integrators.h"

namespace cambrian {

const Registry<IntegratorKind>& builtin_integrators() {
    static const Registry<IntegratorKind> registry = [] {
        Registry<IntegratorKind> kinds;
        kinds.add(bogacki_shampine());
        kinds.add(dormand_prince());
        kinds.add(cash_karp());
        kinds.add(semi_implicit());
        kinds.add(least_squares());
        return kinds;
    }();
    return registry;
}

std::vector<std::string> integrator_ids() {
    std::vector<std::string> ids;
    for (const IntegratorKind& integrator : builtin_integrators().all())
        ids.push_back(integrator.id);
    return ids;
}

}  // namespace cambrian
