#pragma once

// Reads creatures of an experiment file with their lines of descent. Throws DatabaseError if
// anything is missing or impossible.

#include "evolution/individual/individual.h"
#include "persist/creature/genotype_text.h"
#include "persist/records/kept_individuals.h"
#include "persist/sqlite/database.h"

#include <cstdint>
#include <map>
#include <utility>

namespace cambrian {

class IndividualReader {
public:
    IndividualReader(const Database& database, const EvolutionKinds& kinds);

    // Returns the same pointer for the same row. The settings must be those that evaluated the
    // creature.
    IndividualPtr read(const RowRef& row, const ExperimentSettings& settings);

private:
    struct Row {
        Individual individual;  // has a summary of its score
        std::int64_t mother = 0;
    };

    Row read_row(std::int64_t id);
    GenomePtr read_genome(std::int64_t id, std::uint64_t hash);
    EvaluationResult read_result(const RowRef& row);
    IndividualPtr ancestor(std::int64_t id, std::int64_t child);

    const EvolutionKinds& kinds_;
    GenotypeReader genotypes_;
    Statement select_individual_;
    Statement select_genotype_;
    Statement select_result_;
    std::map<std::int64_t, GenomePtr> genomes_;
    std::map<std::int64_t, IndividualPtr> ancestors_;
    std::map<std::pair<std::int64_t, std::int64_t>, IndividualPtr> individuals_;
};

}  // namespace cambrian
