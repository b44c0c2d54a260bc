#pragma once

// The integrators of a scene (planar/README.md 14).

#include "core/registry.h"
#include "planar/stepping/integrator.h"

#include <string>
#include <vector>

namespace cambrian {

// A new integrator is one file in integrators/ and one line in the registry's list.
using IntegratorRegistry = Registry<IntegratorKind>;

// Adaptive 3(2); the default, cheapest with contacts.
void add_bogacki_shampine(IntegratorRegistry& integrators);
// Adaptive 5(4); for accurate replays and smooth motion.
void add_dormand_prince(IntegratorRegistry& integrators);
void add_cash_karp(IntegratorRegistry& integrators);  // adaptive 5(4)
// The reference: slow, dense, three coordinates for each body.
void add_least_squares(IntegratorRegistry& integrators);
void add_semi_implicit(IntegratorRegistry& integrators);  // fixed steps of 1/240 s, first order

const IntegratorRegistry& builtin_integrators();
std::vector<std::string> integrator_ids();

}  // namespace cambrian
