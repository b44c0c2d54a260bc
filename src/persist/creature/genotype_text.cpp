#include "persist/creature/genotype_text.h"

#include "persist/creature/creature_file.h"

#include <fmt/core.h>

#include <memory>

namespace cambrian {
namespace {

// Several times the size of the largest genome's text, in bytes.
constexpr std::int64_t kMostText = 500'000;

Status check_size(std::int64_t size) {
    if (size < 0) return Error{"a genotype's size is negative"};
    if (size <= kMostText) return {};
    return Error{fmt::format("genotype too large: {} bytes", size)};
}

}  // namespace

GenotypePacker::GenotypePacker(const EvolutionKinds& kinds)
    : names_(creature_format::names_of(kinds.creature.catalog)) {}

void GenotypePacker::write(const Individual& individual) {
    text_.clear();
    creature_format::write_genotype(text_, individual, names_);
}

PackedGenotype GenotypePacker::pack(const Individual& individual) {
    write(individual);
    return {deflater_.deflate(text_), text_.size()};
}

PackedGenotype GenotypePacker::pack_difference(const Individual& individual,
                                               std::string_view base) {
    write(individual);
    return {delta_encoder_.encode(text_, base), text_.size()};
}

Result<std::string> GenotypeReader::unpack(std::string_view bytes, std::int64_t size) {
    if (Status small = check_size(size); !small) return small.error();
    return inflater_.inflate(bytes, static_cast<std::size_t>(size));
}

Result<std::string> GenotypeReader::unpack_difference(std::string_view bytes, std::string_view base,
                                                      std::int64_t size) {
    if (Status small = check_size(size); !small) return small.error();
    return delta_decoder_.decode(bytes, base, static_cast<std::size_t>(size));
}

Result<GenomePtr> GenotypeReader::parse(std::string_view text) const {
    Result<CreatureDocument> document = parse_creature(text, "genotype", kinds_);
    if (!document) return document.error();
    return document->creature.individual->genome;
}

Result<GenomePtr> GenotypeReader::read(std::string_view bytes, std::int64_t size) {
    const Result<std::string> text = unpack(bytes, size);
    return text ? parse(*text) : text.error();
}

}  // namespace cambrian
