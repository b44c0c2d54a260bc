#include "planar/integrators/builtin_integrators.h"

namespace cambrian {

const IntegratorRegistry& builtin_integrators() {
    static const IntegratorRegistry registry = [] {
        IntegratorRegistry integrators;
        add_bogacki_shampine(integrators);
        add_dormand_prince(integrators);
        add_cash_karp(integrators);
        add_semi_implicit(integrators);
        add_least_squares(integrators);
        return integrators;
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
