#pragma once

#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>

namespace cambrian {

// One creature with the settings that judge it and the generation it was judged in. Champions,
// starred creatures, creatures on display and cells of a grid are this and what only they know.
// Immutable: copies share the individual and the settings.
struct JudgedIndividual {
    std::uint32_t generation = 0;
    IndividualPtr individual;  // never null once made
    SettingsPtr settings;      // likewise
};

}  // namespace cambrian
