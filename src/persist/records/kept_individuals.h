#pragma once

// Tracks the creatures in an experiment file by row: which ones were written, and which genotypes
// and scores are still needed. Throws DatabaseError.

#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "persist/creature/genotype_text.h"
#include "persist/sqlite/database.h"

#include <cstdint>
#include <map>
#include <span>

namespace cambrian {

// A creature's row and the generation of one of its scores.
struct RowRef {
    std::int64_t individual = 0;
    std::int64_t judged = 0;

    friend bool operator==(const RowRef&, const RowRef&) = default;
};

class KeptIndividuals {
public:
    struct Entry {
        IndividualPtr individual;
        RowRef row;
        bool genotype_held = false;
        bool score_held = false;
    };
    // Keyed by uid.
    using Knowledge = std::map<std::uint64_t, Entry>;

    // `known` describes the file's contents. It must outlive this object and changes along with the
    // file.
    KeptIndividuals(const Database& database, const EvolutionKinds& kinds, Knowledge& known);

    // Registers an individual that is in the file. The genotype of a survivor is never deleted.
    void remember(const IndividualPtr& individual, const RowRef& row, bool survivor);
    // Returns the row of an individual that was written or registered.
    RowRef row_of(const Individual& individual) const;

    // Writes birth, genotype and score unless the file has them. `judged` is the generation of a
    // new score.
    RowRef keep(const IndividualPtr& individual, std::int64_t judged);
    // Protects its genotype and, unless it has another one by now, this score against deletion.
    void hold_score(const IndividualPtr& individual);
    // Deletes genotypes and scores of all individuals that are neither in the population nor
    // protected. Parents and survivors lose only their scores.
    void drop_others(std::span<const IndividualPtr> population);

private:
    Entry insert(const IndividualPtr& individual, std::int64_t judged);
    void insert_score(const Individual& individual, const RowRef& row);
    void update_score(Entry& entry, const IndividualPtr& individual, std::int64_t judged);
    void delete_score(const Entry& entry);
    void hold_parents(const Individual& individual);

    Knowledge& known_;
    GenotypePacker packer_;
    Statement insert_individual_;
    Statement insert_genotype_;
    Statement insert_result_;
    Statement update_individual_;
    Statement delete_genotype_;
    Statement delete_result_;
};

}  // namespace cambrian
