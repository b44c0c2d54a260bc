#include "evolution/generation.h"

#include "breeding/mutation.h"
#include "evolution/selections/quotas.h"
#include "genome/founders/random_genome.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr int kPartnerDraws = 5;

// Data that all children of one generation share.
struct Nursery {
    std::span<const IndividualPtr> ranked;
    const ExperimentSettings& settings;
    const EvolutionKinds& kinds;
    std::uint32_t generation;
    std::span<const double> partner_weights;

    RandomStream stream(std::uint64_t child, Purpose purpose) const {
        return RandomStream(stream_seed(settings.seed, generation, child, purpose));
    }
};

std::vector<const BreedingKind*> assign_methods(const Nursery& nursery, std::size_t children) {
    std::vector<double> shares;
    for (const BreedingKind& kind : nursery.kinds.breeding.all()) {
        const auto& set = nursery.settings.breeding.shares;
        const auto found = set.find(kind.id);
        shares.push_back(found == set.end() ? kind.default_share : found->second);
    }
    const std::vector<std::size_t> counts = largest_remainder(shares, children);
    std::vector<const BreedingKind*> methods;
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        methods.insert(methods.end(), counts[kind], &nursery.kinds.breeding[kind]);
    }
    RandomStream stream = nursery.stream(0, Purpose::kBreeding);
    stream.shuffle(std::span(methods));
    return methods;
}

// Draws another individual than the first parent; after five failed draws, returns the first
// parent.
std::size_t draw_partner(const Nursery& nursery, std::size_t first, RandomStream& stream) {
    std::size_t partner = first;
    for (int draw = 0; draw <= kPartnerDraws && partner == first; ++draw) {
        partner = stream.weighted(nursery.partner_weights);
    }
    return partner;
}

// Returns the breeding method: the first parent's gene if the settings say so, otherwise
// `by_share`.
const BreedingKind* method_of(const Nursery& nursery, std::size_t first,
                              const BreedingKind* by_share) {
    if (nursery.settings.breeding.choice != "attribute") return by_share;
    const std::size_t reproduction = nursery.ranked[first]->genome->reproduction;
    const BreedingKind* own =
        nursery.kinds.breeding.find(nursery.kinds.creature.catalog.reproductions[reproduction]);
    return own == nullptr ? by_share : own;
}

IndividualPtr breed_child(const Nursery& nursery, std::size_t child, std::size_t first,
                          const BreedingKind* method) {
    method = method_of(nursery, first, method);
    RandomStream breeding = nursery.stream(child + 1, Purpose::kBreeding);
    std::size_t second = first;
    if (method->parents > 1) {
        second = draw_partner(nursery, first, breeding);
        if (second == first) method = &single_parent_method(nursery.kinds.breeding);
    }
    return make_child({nursery.ranked[first], nursery.ranked[second], *method}, nursery.settings,
                      nursery.kinds, nursery.generation, child, breeding);
}

}  // namespace

IndividualPtr make_child(const Mating& mating, const ExperimentSettings& settings,
                         const EvolutionKinds& kinds, std::uint32_t generation, std::uint64_t child,
                         RandomStream& breeding) {
    const Individual& mother = *mating.first;
    const bool paired = mating.method.parents > 1;
    const Individual& father = paired ? *mating.second : mother;
    const KindCatalog& catalog = kinds.creature.catalog;
    Genome genome = mating.method.breed(*mother.genome, *father.genome, catalog, breeding);
    RandomStream mutation(stream_seed(settings.seed, generation, child, Purpose::kMutation));
    std::vector<MutationRecord> mutations =
        mutate(genome, settings.mutation, kinds.mutations,
               {.catalog = catalog,
                .founders = settings.founders,
                .mutate_reproduction = settings.breeding.choice == "attribute"},
               mutation, mating.extra_mutations);
    genome.name.clear();
    Individual individual = make_individual(std::make_shared<const Genome>(std::move(genome)),
                                            settings, generation, child, mating.method.id);
    individual.parents = {mother.uid, paired ? father.uid : 0};
    individual.mother = ParentLink(mating.first);
    individual.line = mother.line;
    for (const Individual* parent : {&father, &mother}) {
        if (same_body(*individual.genome, *parent->genome))
            individual.body_born = parent->body_born;
    }
    individual.mutations = std::move(mutations);
    individual.expected_work = std::max(mother.result.work, father.result.work);
    return std::make_shared<const Individual>(std::move(individual));
}

IndividualPtr make_newcomer(const ExperimentSettings& settings, const EvolutionKinds& kinds,
                            std::uint32_t generation, std::uint64_t child) {
    RandomStream stream(stream_seed(settings.seed, generation, child, Purpose::kFounder));
    auto genome = std::make_shared<const Genome>(
        random_genome(settings.founders, kinds.creature.catalog, stream));
    return std::make_shared<const Individual>(
        make_individual(std::move(genome), settings, generation, child, "random"));
}

Individual make_individual(GenomePtr genome, const ExperimentSettings& settings,
                           std::uint32_t generation, std::uint64_t child, std::string method) {
    Individual individual;
    individual.uid = stream_seed({settings.seed, generation, child});
    individual.born = generation;
    individual.body_born = generation;
    individual.line = individual.uid;
    individual.genome_hash = genome_hash(*genome);
    individual.genome = std::move(genome);
    individual.method = std::move(method);
    return individual;
}

namespace {

SelectionResult select(std::span<const IndividualPtr> ranked, const ExperimentSettings& settings,
                       const EvolutionKinds& kinds, std::uint32_t generation,
                       SelectionMemory& memory) {
    const SelectionKind* selection = kinds.selections.find(settings.selection.method);
    CAMBRIAN_ASSERT(selection != nullptr, "settings were checked");
    RandomStream stream(stream_seed(settings.seed, generation, 0, Purpose::kSelection));
    return selection->select(ranked, settings, memory, stream);
}

}  // namespace

std::vector<std::size_t> survivors_of(std::span<const IndividualPtr> ranked,
                                      const ExperimentSettings& settings,
                                      const EvolutionKinds& kinds, std::uint32_t generation,
                                      SelectionMemory memory) {
    return select(ranked, settings, kinds, generation, memory).survivors;
}

std::vector<IndividualPtr> next_generation(std::span<const IndividualPtr> ranked,
                                           const ExperimentSettings& settings,
                                           const EvolutionKinds& kinds, std::uint32_t generation,
                                           SelectionMemory& memory) {
    const SelectionResult selected = select(ranked, settings, kinds, generation, memory);
    const Nursery nursery{ranked, settings, kinds, generation, selected.partner_weights};

    std::vector<IndividualPtr> next;
    for (const std::size_t survivor : selected.survivors)
        next.push_back(ranked[survivor]);
    const std::size_t children = selected.first_parents.size();
    const std::vector<const BreedingKind*> methods = assign_methods(nursery, children);
    for (std::size_t child = 0; child < children; ++child) {
        next.push_back(breed_child(nursery, child, selected.first_parents[child], methods[child]));
    }
    for (std::uint64_t child = children; child < children + selected.newcomers; ++child)
        next.push_back(make_newcomer(settings, kinds, generation, child));
    return next;
}

}  // namespace cambrian
