#include "picking/handover.h"

#include <utility>

namespace cambrian {

std::vector<GenomePtr> genomes_of(std::span<const IndividualPtr> creatures) {
    std::vector<GenomePtr> genomes;
    genomes.reserve(creatures.size());
    for (const IndividualPtr& creature : creatures)
        genomes.push_back(creature->genome);
    return genomes;
}

std::vector<EngineCommand> injection_of(std::span<const IndividualPtr> picks) {
    std::vector<EngineCommand> commands;
    for (GenomePtr& genome : genomes_of(picks))
        commands.emplace_back(InjectGenome{std::move(genome)});
    return commands;
}

}  // namespace cambrian
