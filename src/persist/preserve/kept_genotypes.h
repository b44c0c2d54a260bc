#pragma once

// Reads the genotypes of a preserve file. A row has the compressed text of a creature document or
// its difference from that of another creature, its base.

#include "persist/creature/genotype_text.h"
#include "persist/sqlite/database.h"

#include <cstdint>
#include <string>

namespace cambrian {

// The largest number of differences from one text to another.
inline constexpr std::size_t kMostDifferences = 32;

struct KeptText {
    std::string text;
    std::size_t differences = 0;  // from a text without a base
};

// The functions throw DatabaseError if the database cannot be read.
class KeptGenotypes {
public:
    // Both must outlive the object.
    KeptGenotypes(const Database& database, const EvolutionKinds& kinds);

    // Fails if there is no such creature, or if its genotype is damaged.
    Result<GenomePtr> genome(std::uint64_t number);
    Result<KeptText> text(std::uint64_t number);

private:
    Statement select_;
    GenotypeReader reader_;
};

}  // namespace cambrian
