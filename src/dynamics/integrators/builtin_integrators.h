#pragma once

// The integrators of a scene (dynamics/README.md 14).

#include "core/registry.h"
#include "dynamics/stepping/integrator.h"

#include <string>
#include <vector>

namespace cambrian {

// A new integrator is one file in integrators/ and one line in the registry's list.
IntegratorKind bogacki_shampine();  // adaptive 3(2); the default, cheapest with contacts
IntegratorKind dormand_prince();    // adaptive 5(4); for accurate replays and smooth motion
IntegratorKind cash_karp();         // adaptive 5(4)
IntegratorKind least_squares();     // the reference: slow, dense, three coordinates for each body
IntegratorKind semi_implicit();     // fixed steps of 1/240 s, first order

const Registry<IntegratorKind>& builtin_integrators();
std::vector<std::string> integrator_ids();

}  // namespace cambrian
