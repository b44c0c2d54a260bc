#include "genome/gene_fields.h"

#include <algorithm>
#include <array>
#include <type_traits>

namespace cambrian {
namespace {

// Returns the real numbers of a table, those of the plane first.
template <class Gene, class... Fields>
constexpr auto numbers_in(const std::tuple<Fields...>& fields) {
    std::array<GeneField<Gene>, (std::size_t{std::is_same_v<Fields, GeneField<Gene>>} + ...)>
        numbers{};
    std::size_t count = 0;
    const auto take = [&](const auto& field, bool of_space) {
        if constexpr (std::is_same_v<decltype(field), const GeneField<Gene>&>) {
            if ((field.use == FieldUse::kBodyInSpace) == of_space) numbers[count++] = field;
        }
    };
    for (const bool of_space : {false, true})
        std::apply([&](const auto&... field) { (take(field, of_space), ...); }, fields);
    return numbers;
}

template <class Gene>
std::span<const GeneField<Gene>> numbers_of(int dimensions) {
    static constexpr auto kNumbers = numbers_in<Gene>(gene_tables::kFields<Gene>);
    const auto end = std::find_if(kNumbers.begin(), kNumbers.end(),
                                  [&](const auto& field) { return !field.is_of(dimensions); });
    return {kNumbers.begin(), end};
}

}  // namespace

std::span<const GeneField<NodeGene>> node_fields(int dimensions) {
    return numbers_of<NodeGene>(dimensions);
}
std::span<const GeneField<EdgeGene>> edge_fields(int dimensions) {
    return numbers_of<EdgeGene>(dimensions);
}
std::span<const GeneField<InputGene>> input_fields() {
    return numbers_of<InputGene>(3);
}
std::span<const GeneField<Genome>> genome_fields(int dimensions) {
    return numbers_of<Genome>(dimensions);
}
std::span<const GeneField<DegreeGene>> degree_fields() {
    return numbers_of<DegreeGene>(3);
}

}  // namespace cambrian
