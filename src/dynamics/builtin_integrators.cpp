#include "dynamics/builtin_integrators.h"

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

}  // namespace cambrian
