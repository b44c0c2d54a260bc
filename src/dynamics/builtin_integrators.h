#pragma once

// The integration methods a scene may be computed with.

#include "core/registry.h"
#include "dynamics/integrator.h"

namespace cambrian {

// A new method is one file in integrators/ and one line in the registry's list.
IntegratorKind bogacki_shampine();  // adaptive 3(2); the default

const Registry<IntegratorKind>& builtin_integrators();

}  // namespace cambrian
