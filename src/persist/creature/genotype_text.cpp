#include "persist/creature/genotype_text.h"

#include "persist/creature/creature_file.h"

#include <fmt/core.h>

#include <memory>

namespace cambrian {
namespace {

// Several times the size of the largest genome's text, in bytes.
constexpr std::size_t kMostText = 500'000;

}  // namespace

GenotypePacker::GenotypePacker(const EvolutionKinds& kinds)
    : names_(creature_format::names_of(kinds.creature.catalog)) {}

PackedGenotype GenotypePacker::pack(const Individual& individual) {
    text_.clear();
    creature_format::write_genotype(text_, individual, names_);
    return {deflater_.deflate(text_), text_.size()};
}

Result<GenomePtr> GenotypeReader::read(std::string_view bytes, std::size_t size) {
    if (size > kMostText) return Error{fmt::format("genotype too large: {} bytes", size)};
    const Result<std::string> text = inflater_.inflate(bytes, size);
    if (!text) return text.error();
    Result<CreatureDocument> document = parse_creature(*text, "genotype", kinds_);
    if (!document) return document.error();
    return document->creature.individual->genome;
}

}  // namespace cambrian
