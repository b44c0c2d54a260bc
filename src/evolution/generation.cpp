#include "evolution/generation.h"

#include "breeding/mutation.h"
#include "breeding/mutations/tuning.h"
#include "evolution/selections/quotas.h"
#include "evolution/tuned_parents.h"
#include "genome/founders/random_genome.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr int kPartnerDraws = 5;
// The stream of a generation's selection from which parents of tuned children are drawn.
constexpr std::uint64_t kTuningStream = 1;

// Data that all children of one generation share.
struct ReproductionContext {
    std::span<const IndividualPtr> ranked;
    const ExperimentSettings& settings;
    const EvolutionKinds& kinds;
    std::uint32_t generation;
    std::span<const double> partner_weights;

    RandomStream stream(std::uint64_t child, Purpose purpose) const {
        return RandomStream(stream_seed(settings.seed, generation, child, purpose));
    }
};

std::vector<const BreedingKind*> assign_methods(const ReproductionContext& context,
                                                std::size_t children) {
    std::vector<double> shares;
    for (const BreedingKind& kind : context.kinds.breeding.all()) {
        const auto& set = context.settings.breeding.shares;
        const auto found = set.find(kind.id);
        shares.push_back(found == set.end() ? kind.default_share : found->second);
    }
    const std::vector<std::size_t> counts = largest_remainder(shares, children);
    std::vector<const BreedingKind*> methods;
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        methods.insert(methods.end(), counts[kind], &context.kinds.breeding[kind]);
    }
    RandomStream stream = context.stream(0, Purpose::kBreeding);
    stream.shuffle(std::span(methods));
    return methods;
}

// Draws another individual than the first parent; after six failed draws, returns the first
// parent.
std::size_t draw_partner(const ReproductionContext& context, std::size_t first,
                         RandomStream& stream) {
    std::size_t partner = first;
    for (int draw = 0; draw <= kPartnerDraws && partner == first; ++draw) {
        partner = stream.weighted(context.partner_weights);
    }
    return partner;
}

// Returns the breeding method: the first parent's gene if the settings say so, otherwise
// `by_share`.
const BreedingKind* method_of(const ReproductionContext& context, std::size_t first,
                              const BreedingKind* by_share) {
    if (context.settings.breeding.choice != "attribute") return by_share;
    const std::size_t reproduction = context.ranked[first]->genome->reproduction;
    const BreedingKind* own =
        context.kinds.breeding.find(context.kinds.creature.catalog.reproductions[reproduction]);
    return own == nullptr ? by_share : own;
}

IndividualPtr breed_child(const ReproductionContext& context, std::size_t child, std::size_t first,
                          const BreedingKind* method) {
    method = method_of(context, first, method);
    RandomStream breeding = context.stream(child + 1, Purpose::kBreeding);
    std::size_t second = first;
    if (method->parents > 1) {
        second = draw_partner(context, first, breeding);
        if (second == first) method = &single_parent_method(context.kinds.breeding);
    }
    return make_child({context.ranked[first], context.ranked[second], *method}, context.settings,
                      context.kinds, context.generation, child, breeding);
}

// Returns a copy of a creature with tuned numbers.
IndividualPtr breed_tuned_child(const ReproductionContext& context, std::size_t child,
                                std::size_t parent) {
    RandomStream breeding = context.stream(child + 1, Purpose::kBreeding);
    const IndividualPtr& mother = context.ranked[parent];
    return make_child({.first = mother,
                       .second = mother,
                       .method = single_parent_method(context.kinds.breeding),
                       .tuned = true},
                      context.settings, context.kinds, context.generation, child, breeding);
}

std::vector<MutationRecord> change(Genome& genome, const ParentPair& pair,
                                   const ExperimentSettings& settings, const EvolutionKinds& kinds,
                                   RandomStream& stream) {
    const KindCatalog& catalog = kinds.creature.catalog;
    if (pair.tuned) {
        const IndividualPtr& before = pair.first->mother.get();
        const Genome* old = before == nullptr ? nullptr : before->genome.get();
        return {tune(genome, old, catalog, stream)};
    }
    return mutate(genome, settings.mutation, kinds.mutations,
                  {.catalog = catalog,
                   .founders = settings.founders,
                   .mutate_reproduction = settings.breeding.choice == "attribute"},
                  stream, pair.extra_mutations);
}

}  // namespace

IndividualPtr make_child(const ParentPair& pair, const ExperimentSettings& settings,
                         const EvolutionKinds& kinds, std::uint32_t generation, std::uint64_t child,
                         RandomStream& breeding) {
    const Individual& mother = *pair.first;
    const bool paired = pair.method.parents > 1;
    const Individual& father = paired ? *pair.second : mother;
    Genome genome =
        pair.method.breed(*mother.genome, *father.genome, kinds.creature.catalog, breeding);
    RandomStream mutation(stream_seed(settings.seed, generation, child, Purpose::kMutation));
    std::vector<MutationRecord> mutations = change(genome, pair, settings, kinds, mutation);
    genome.name.clear();
    Individual individual =
        make_individual(std::make_shared<const Genome>(std::move(genome)), settings, generation,
                        child, pair.tuned ? "tuning" : pair.method.id);
    individual.parents = {mother.uid, paired ? father.uid : 0};
    individual.mother = ParentLink(pair.first);
    individual.line = mother.line;
    for (const Individual* parent : {&father, &mother}) {
        if (differing_body_genes(*individual.genome, *parent->genome) == 0)
            individual.body_born = parent->body_born;
    }
    individual.mutations = std::move(mutations);
    individual.expected_work = std::max(mother.result.work, father.result.work);
    return std::make_shared<const Individual>(std::move(individual));
}

IndividualPtr make_immigrant(const ExperimentSettings& settings, const EvolutionKinds& kinds,
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
    const ReproductionContext context{ranked, settings, kinds, generation,
                                      selected.partner_weights};

    std::vector<IndividualPtr> next;
    for (const std::size_t survivor : selected.survivors)
        next.push_back(ranked[survivor]);
    const std::size_t children = selected.first_parents.size();
    const std::vector<const BreedingKind*> methods = assign_methods(context, children);
    RandomStream tuning = context.stream(kTuningStream, Purpose::kSelection);
    const double share = settings.mutation.mutates() ? settings.population.tuned : 0.0;
    const auto tuned = draw_tuned_parents(ranked, selected.survivors, children, share, tuning);
    for (std::size_t child = 0; child < children; ++child) {
        next.push_back(tuned[child] ? breed_tuned_child(context, child, *tuned[child])
                                    : breed_child(context, child, selected.first_parents[child],
                                                  methods[child]));
    }
    for (std::uint64_t child = children; child < children + selected.immigrants; ++child)
        next.push_back(make_immigrant(settings, kinds, generation, child));
    return next;
}

}  // namespace cambrian
