#include "studio/playback/exhibit.h"

#include "evolution/individual/ancestry_digest.h"

#include <fmt/core.h>

#include <utility>

namespace cambrian {

Exhibit exhibit_of(JudgedIndividual creature, ExhibitSource source) {
    Exhibit exhibit;
    exhibit.source = source;
    exhibit.title = source == ExhibitSource::kChampion
                        ? fmt::format("Champion of generation {}", creature.generation)
                        : fmt::format("Creature of generation {}", creature.generation);
    exhibit.ancestry = ancestry_digest(*creature.individual);
    exhibit.creature = std::move(creature);
    return exhibit;
}

}  // namespace cambrian
