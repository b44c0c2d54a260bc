// random_creatures COUNT [DIMENSIONS] prints the files of random creatures as one JSON list. Some
// are founders, the others genomes repaired from garbage, whose values are at the ends of their
// ranges.

#include "genome/founders/random_genome.h"
#include "genome/random_garbage.h"
#include "persist/creature/creature_file.h"
#include "support/kinds.h"

#include <cstdio>
#include <cstdlib>

using namespace cambrian;
using namespace cambrian::test;

namespace {

CreatureDocument random_document(const KindCatalog& catalog, RandomStream& stream) {
    Genome genome;
    if (stream.chance(0.5)) {
        genome = random_genome(FounderSettings{}, catalog, stream);
    } else {
        genome = garbage_genome(stream);
        repair(genome, catalog);
    }
    CreatureDocument document{unjudged(std::make_shared<const Genome>(std::move(genome)))};
    if (stream.chance(0.1)) {
        change_individual(document.creature,
                          [](Individual& individual) { individual.evaluated = true; });
    }
    return document;
}

}  // namespace

int main(int argc, char** argv) {
    const int count = argc > 1 ? std::atoi(argv[1]) : 1;
    const EvolutionKinds& all = argc > 2 && std::atoi(argv[2]) == 3 ? spatial_kinds() : kinds();
    RandomStream stream(91);
    for (int i = 0; i < count; ++i) {
        const std::string text = write_creature(random_document(all.creature.catalog, stream), all);
        std::printf("%s%s", i == 0 ? "[" : ",\n", text.c_str());
    }
    std::puts("]");
}
