#pragma once

// Computes the creatures of a unit, one after the other.

#include "cluster/messages/result_text.h"
#include "cluster/messages/unit_text.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"

#include <stop_token>

namespace cambrian {

// Returns results of the creatures that were finished: all of them unless a stop was requested.
UnitResult compute_unit(const Unit& unit, const ExperimentSettings& settings,
                        const EvolutionKinds& kinds, const std::stop_token& stop);

}  // namespace cambrian
