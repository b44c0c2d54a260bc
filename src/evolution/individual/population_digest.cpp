#include "evolution/individual/population_digest.h"

namespace cambrian {

void add_population(Hash64& hash, std::span<const IndividualPtr> population) {
    for (const IndividualPtr& one : population) {
        hash.add(one->uid);
        hash.add(one->genome_hash);
        hash.add(one->result.fitness);
        hash.add(one->result.digest);
    }
}

std::uint64_t population_digest(std::span<const IndividualPtr> population) {
    Hash64 hash;
    add_population(hash, population);
    return hash.value();
}

}  // namespace cambrian
