#pragma once

#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>

namespace cambrian {

// A creature with the settings that evaluate it and the generation of the evaluation. Champions,
// starred creatures, exhibits and cells of a grid contain one. It is immutable; copies share the
// individual and the settings.
struct JudgedIndividual {
    std::uint32_t generation = 0;
    IndividualPtr individual;  // never null after construction
    SettingsPtr settings;      // never null after construction
};

}  // namespace cambrian
