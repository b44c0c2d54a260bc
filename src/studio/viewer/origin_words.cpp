#include "studio/viewer/origin_words.h"

#include "core/text/pretty_text.h"
#include "genome/creature_name.h"
#include "studio/playback/exhibit.h"
#include "studio/viewer/mutation_words.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

constexpr std::size_t kMostMutations = 6;  // lines of mutations; the rest are only counted
constexpr std::size_t kShortUid = 8;       // digits shown of a uid

std::string parent_words(std::uint64_t parent, std::span<const IndividualPtr> population) {
    const auto living =
        std::find_if(population.begin(), population.end(),
                     [parent](const IndividualPtr& each) { return each->uid == parent; });
    if (living == population.end()) return uid_text(parent).substr(0, kShortUid);
    return fmt::format("{} (rank {})", creature_name(*(*living)->genome),
                       living - population.begin() + 1);
}

}  // namespace

std::string method_words(const std::string& method, const EvolutionKinds& kinds) {
    const BreedingKind* kind = kinds.breeding.find(method);
    return kind == nullptr ? capitalized(method) : kind->label;
}

std::string origin_words(const Individual& individual, std::span<const IndividualPtr> population,
                         const EvolutionKinds& kinds) {
    std::string words = fmt::format("Born in generation {}\n{}", individual.born,
                                    method_words(individual.method, kinds));
    for (std::size_t i = 0; i < individual.parents.size(); ++i) {
        if (individual.parents[i] == 0) continue;
        words += i == 0 ? ", from " : " and ";
        words += parent_words(individual.parents[i], population);
    }
    const auto& mutations = individual.mutations;
    for (std::size_t i = 0; i < std::min(mutations.size(), kMostMutations); ++i)
        words += "\n" + mutation_words(mutations[i], kinds.mutations);
    if (mutations.size() > kMostMutations)
        words += fmt::format("\nand {} more mutations", mutations.size() - kMostMutations);
    return words;
}

}  // namespace cambrian
