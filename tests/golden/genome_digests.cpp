#include "breeding/mutation.h"
#include "core/hash.h"
#include "core/random.h"
#include "golden/founders.h"
#include "golden/golden.h"
#include "support/kinds.h"

namespace cambrian::golden {
namespace {

constexpr int kFounders = 200;
constexpr int kMutations = 12;  // rounds of mutation

std::uint64_t digest_of(const std::vector<Genome>& genomes) {
    Hash64 hash;
    for (const Genome& genome : genomes)
        hash.add(genome_hash(genome));
    return hash.value();
}

void add_part(Hash64& hash, const PlannedPart& part) {
    for (int i = 0; i < 3; ++i) {
        hash.add(part.half_extents[i]);
        hash.add(part.rest_pose.position[i]);
        hash.add(part.anchor_in_parent[i]);
        hash.add(part.anchor_in_child[i]);
    }
    for (const double number : {part.rest_angle, part.limit_low, part.limit_high, part.max_effort})
        hash.add(number);
    hash.add(static_cast<std::uint64_t>(part.parent));
    hash.add_byte(static_cast<std::uint8_t>(part.motion));
}

void add_network(Hash64& hash, const Network& network) {
    for (const NetworkNeuron& neuron : network.neurons) {
        hash.add_byte(neuron.function);
        for (const NetworkInput& input : neuron.inputs) {
            hash.add(std::uint64_t{input.slot});
            hash.add(input.weight);
        }
    }
    for (const std::uint32_t neuron : network.order)
        hash.add(std::uint64_t{neuron});
}

std::uint64_t digest_of_bodies(const std::vector<Genome>& genomes,
                               const Kinds& kinds = test::creature_kinds()) {
    Hash64 hash;
    for (const Genome& genome : genomes) {
        const Phenotype grown = express(genome, kinds, {}, {});
        for (const PlannedPart& part : grown.plan.parts)
            add_part(hash, part);
        add_network(hash, grown.network);
        hash.add(grown.rest_length());
        hash.add(grown.mass(1.0));
    }
    return hash.value();
}

std::vector<Genome> mutants_of(std::vector<Genome> genomes, const MutationSettings& settings,
                               const FounderSettings& founders = all_joints()) {
    const MutationContext context{test::kinds().creature.catalog, founders, true};
    for (std::size_t i = 0; i < genomes.size(); ++i) {
        RandomStream random(stream_seed({12, i}));
        for (int round = 0; round < kMutations; ++round)
            mutate(genomes[i], settings, test::kinds().mutations, context, random);
    }
    return genomes;
}

std::vector<Genome> children_of(const std::vector<Genome>& genomes, const BreedingKind& method) {
    std::vector<Genome> children;
    for (std::size_t i = 0; i < genomes.size(); ++i) {
        RandomStream random(stream_seed({13, i}));
        const Genome& second = method.parents == 1 ? genomes[i] : random.pick(genomes);
        children.push_back(
            method.breed(genomes[i], second, test::kinds().creature.catalog, random));
    }
    return children;
}

}  // namespace

void add_genome_digests(Digests& digests) {
    std::vector<Genome> founders;
    for (int i = 0; i < kFounders; ++i)
        founders.push_back(founder(i));
    digests.push_back({"genome.founders", digest_of(founders)});
    digests.push_back({"genome.founders.bodies", digest_of_bodies(founders)});
    MutationSettings gate;
    gate.scheme = "gate";
    gate.rate = 1.5;
    digests.push_back({"genome.mutants.gate", digest_of(mutants_of(founders, gate))});
    const std::vector<Genome> mutants = mutants_of(founders, {});
    digests.push_back({"genome.mutants", digest_of(mutants)});
    digests.push_back({"genome.mutants.bodies", digest_of_bodies(mutants)});
    for (const BreedingKind& method : test::kinds().breeding.all())
        digests.push_back(
            {"genome.children." + method.id, digest_of(children_of(mutants, method))});
    std::vector<Genome> with_organs;
    for (int i = 0; i < kFounders; ++i)
        with_organs.push_back(founder_with_organs(i));
    digests.push_back({"genome.organs", digest_of(with_organs)});
    digests.push_back(
        {"genome.organs.mutants", digest_of(mutants_of(with_organs, {}, with_emitters()))});
    std::vector<Genome> deforming;
    for (int i = 0; i < kFounders; ++i)
        deforming.push_back(founder_with_deformers(i));
    digests.push_back({"genome.deformers", digest_of(mutants_of(deforming, {}, with_deformers()))});
    const Kinds& kinds_of_space = test::spatial_kinds().creature;
    std::vector<Genome> in_space;
    for (int i = 0; i < kFounders; ++i)
        in_space.push_back(founder(i, kinds_of_space.catalog));
    digests.push_back({"space.founders", digest_of(in_space)});
    digests.push_back({"space.founders.bodies", digest_of_bodies(in_space, kinds_of_space)});
}

}  // namespace cambrian::golden
