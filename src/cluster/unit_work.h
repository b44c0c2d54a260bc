#pragma once

// Computes the creatures of a unit, one after the other.

#include "cluster/result_text.h"
#include "cluster/unit_text.h"
#include "evolution/evolution_kinds.h"
#include "evolution/experiment_settings.h"

#include <stop_token>

namespace cambrian {

// Results of the creatures that were finished; all of them unless a stop was asked for.
UnitResult compute_unit(const Unit& unit, const ExperimentSettings& settings,
                        const EvolutionKinds& kinds, const std::stop_token& stop);

}  // namespace cambrian
