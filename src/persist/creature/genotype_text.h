#pragma once

// Genotypes in experiment files: compressed creature documents without a score.

#include "core/deflated_text.h"
#include "core/result.h"
#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "persist/creature/creature_format.h"

#include <cstddef>
#include <string>
#include <string_view>

namespace cambrian {

struct PackedGenotype {
    std::string_view bytes;  // valid until the next call
    std::size_t size = 0;    // bytes of the uncompressed text
};

class GenotypePacker {
public:
    explicit GenotypePacker(const EvolutionKinds& kinds);
    // The individual's uid, parents and method may be empty.
    PackedGenotype pack(const Individual& individual);

private:
    creature_format::KindNames names_;
    std::string text_;
    Deflater deflater_;
};

class GenotypeReader {
public:
    explicit GenotypeReader(const EvolutionKinds& kinds) : kinds_(kinds) {}
    Result<GenomePtr> read(std::string_view bytes, std::size_t size);

private:
    const EvolutionKinds& kinds_;
    Inflater inflater_;
};

}  // namespace cambrian
