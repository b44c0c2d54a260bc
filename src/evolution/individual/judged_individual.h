#pragma once

#include "evolution/individual/individual.h"
#include "evolution/settings/experiment_settings.h"

#include <cstdint>
#include <string>
#include <utility>

namespace cambrian {

// A creature with the settings that evaluate it and the generation of the evaluation. Champions,
// starred creatures, exhibits, documents, pictures and cells of a grid contain one. It is
// immutable; copies share the individual and the settings.
struct JudgedIndividual {
    std::uint32_t generation = 0;
    IndividualPtr individual = {};  // never null after construction
    SettingsPtr settings = {};      // never null after construction

    const Genome& genome() const { return *individual->genome; }
};

// Returns a creature that was never evaluated, with the settings that are to evaluate it.
JudgedIndividual unjudged(GenomePtr genome,
                          SettingsPtr settings = std::make_shared<const ExperimentSettings>(),
                          const std::string& method = {});

// Replaces the individual by a copy that `change` has edited.
template <class Change>
void change_individual(JudgedIndividual& creature, Change change) {
    Individual edited = *creature.individual;
    change(edited);
    creature.individual = std::make_shared<const Individual>(std::move(edited));
}

// Replaces the settings by a copy that `change` has edited.
template <class Change>
void change_settings(JudgedIndividual& creature, Change change) {
    ExperimentSettings edited = *creature.settings;
    change(edited);
    creature.settings = std::make_shared<const ExperimentSettings>(std::move(edited));
}

}  // namespace cambrian
