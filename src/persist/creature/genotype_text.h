#pragma once

// Genotypes in experiment and preserve files: compressed creature documents without a score.

#include "core/deflated_text.h"
#include "core/delta_text.h"
#include "core/result.h"
#include "evolution/individual/individual.h"
#include "evolution/kinds/evolution_kinds.h"
#include "persist/creature/creature_format.h"

#include <cstddef>
#include <cstdint>
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
    // Does the same with the difference from another genotype's text.
    PackedGenotype pack_difference(const Individual& individual, std::string_view base);

private:
    void write(const Individual& individual);

    creature_format::KindNames names_;
    std::string text_;
    Deflater deflater_;
    DeltaEncoder delta_encoder_;
};

class GenotypeReader {
public:
    explicit GenotypeReader(const EvolutionKinds& kinds) : kinds_(kinds) {}
    // `size` is the number of bytes of the text, as a file has it. Fails at any that no genotype
    // has.
    Result<GenomePtr> read(std::string_view bytes, std::int64_t size);
    Result<std::string> unpack(std::string_view bytes, std::int64_t size);
    // Does the same with the difference from another genotype's text.
    Result<std::string> unpack_difference(std::string_view bytes, std::string_view base,
                                          std::int64_t size);
    Result<GenomePtr> parse(std::string_view text) const;

private:
    const EvolutionKinds& kinds_;
    Inflater inflater_;
    DeltaDecoder delta_decoder_;
};

}  // namespace cambrian
