#pragma once

#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <string>
#include <utility>

namespace cambrian {

// One creature with the settings that judge it and the generation it was judged in. Champions,
// starred creatures, creatures on display and in files, those of pictures and cells of a grid are
// this and what only they know. Immutable: copies share the individual and the settings.
struct JudgedIndividual {
    std::uint32_t generation = 0;
    IndividualPtr individual = {};  // never null once made
    SettingsPtr settings = {};      // likewise

    const Genome& genome() const { return *individual->genome; }
};

// A creature that was never judged, under the settings that are to judge it.
JudgedIndividual unjudged(GenomePtr genome,
                          SettingsPtr settings = std::make_shared<const ExperimentSettings>(),
                          const std::string& method = {});

// Gives the creature another individual: a copy of its own that `change` has edited.
template <class Change>
void change_individual(JudgedIndividual& creature, Change change) {
    Individual edited = *creature.individual;
    change(edited);
    creature.individual = std::make_shared<const Individual>(std::move(edited));
}

// Gives the creature other settings in the same way.
template <class Change>
void change_settings(JudgedIndividual& creature, Change change) {
    ExperimentSettings edited = *creature.settings;
    change(edited);
    creature.settings = std::make_shared<const ExperimentSettings>(std::move(edited));
}

}  // namespace cambrian
