#include "evolution/individual/judged_individual.h"

namespace cambrian {

JudgedIndividual unjudged(GenomePtr genome, SettingsPtr settings, const std::string& method) {
    Individual individual;
    individual.genome_hash = genome_hash(*genome);
    individual.genome = std::move(genome);
    individual.method = method;
    return {.individual = std::make_shared<const Individual>(std::move(individual)),
            .settings = std::move(settings)};
}

}  // namespace cambrian
