#include "studio/playback/exhibit.h"

#include "evolution/individual/ancestry_digest.h"
#include "genome/creature_name.h"

#include <fmt/core.h>

#include <utility>

namespace cambrian {

std::string Exhibit::name() const {
    if (creature.individual == nullptr) return title;
    const bool of_file = source == ExhibitSource::kSample || source == ExhibitSource::kFile;
    return of_file && genome()->name.empty() ? title : creature_name(*genome());
}

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
