#pragma once

// Genomes to breed from in tests: founders, single parts and descendants after many mutations.

#include "brain/neuron_function.h"
#include "breeding/breeding_kind.h"
#include "breeding/mutation.h"
#include "genome/founders/random_genome.h"
#include "genome/small_catalog.h"

#include <vector>

namespace cambrian {

// The real functions with the planar joints and channels.
inline const KindCatalog& full_catalog() {
    static const KindCatalog catalog = [] {
        KindCatalog made = small_catalog();
        made.functions.clear();
        const NeuronFunctionRegistry functions = builtin_neuron_functions();
        for (const NeuronFunctionKind& function : functions.all()) {
            FunctionEntry entry{function.id, function.label, function.arity, {}};
            for (const auto& hint : function.input_hints)
                entry.founder_inputs.push_back({hint.probability, hint.low, hint.high});
            made.functions.push_back(entry);
        }
        return made;
    }();
    return catalog;
}

inline RandomStream test_stream(std::uint64_t number) {
    return RandomStream(stream_seed(2024, 0, number, Purpose::kTest));
}

inline const FounderSettings& default_founders() {
    static const FounderSettings settings;
    return settings;
}

inline MutationContext default_context() {
    return {full_catalog(), default_founders()};
}

inline std::vector<Genome> founder_corpus(std::size_t count) {
    std::vector<Genome> genomes;
    for (std::size_t i = 0; i < count; ++i) {
        RandomStream stream = test_stream(i);
        genomes.push_back(random_genome(default_founders(), full_catalog(), stream));
    }
    return genomes;
}

inline std::vector<Genome> single_part_corpus(std::size_t count) {
    std::vector<Genome> genomes;
    for (Genome& genome : founder_corpus(count)) {
        genome.nodes.resize(1);
        repair(genome, full_catalog());
        genomes.push_back(std::move(genome));
    }
    return genomes;
}

// Returns founders after many rounds of mutation.
inline std::vector<Genome> evolved_corpus(std::size_t count, int rounds = 60) {
    const MutationRegistry mutations = builtin_mutations();
    std::vector<Genome> genomes = founder_corpus(count);
    for (std::size_t i = 0; i < count; ++i) {
        RandomStream stream = test_stream(1000000 + i);
        for (int round = 0; round < rounds; ++round)
            mutate(genomes[i], {}, mutations, default_context(), stream);
    }
    return genomes;
}

}  // namespace cambrian
