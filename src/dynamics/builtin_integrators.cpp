#include "dynamics/builtin_integrators.h"

namespace cambrian {

const Registry<IntegratorKind>& builtin_integrators() {
    static const Registry<IntegratorKind> registry = [] {
        Registry<IntegratorKind> kinds;
        kinds.add(bogacki_shampine());
        return kinds;
    }();
    return registry;
}

}  // namespace cambrian
