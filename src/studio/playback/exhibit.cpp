#include "studio/playback/exhibit.h"

#include "evolution/individual/ancestry_digest.h"
#include "persist/text/digest_text.h"

#include <utility>

namespace cambrian {

std::string uid_text(std::uint64_t uid) {
    return uid == 0 ? std::string() : hex_text(uid);
}

Exhibit exhibit_of(JudgedIndividual creature, ExhibitSource source) {
    Exhibit exhibit;
    exhibit.source = source;
    exhibit.title = source == ExhibitSource::kChampion
                        ? "Champion of generation " + std::to_string(creature.generation)
                        : "Creature of generation " + std::to_string(creature.generation);
    exhibit.ancestry = ancestry_digest(*creature.individual);
    exhibit.creature = std::move(creature);
    return exhibit;
}

JudgedIndividual unjudged(GenomePtr genome, SettingsPtr settings, const std::string& method) {
    Individual individual;
    individual.genome_hash = genome_hash(*genome);
    individual.genome = std::move(genome);
    individual.method = method;
    return {.individual = std::make_shared<const Individual>(std::move(individual)),
            .settings = std::move(settings)};
}

}  // namespace cambrian
