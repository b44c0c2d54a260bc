#include "picking/grid/grid_breeding.h"

#include "evolution/generation.h"
#include "evolution/selections/quotas.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kCandidatesPerCell = 3;
constexpr std::size_t kCopiesEach = 2;
// Child index of the first imported creature; larger than that of any bred one.
constexpr std::uint64_t kFirstImported = std::uint64_t{1} << 32;

ExperimentSettings with_picking_seed(const ExperimentSettings& settings) {
    ExperimentSettings changed = settings;
    changed.seed = picking_seed(settings);
    return changed;
}

// Returns the method for each of `count` children of two parents. If there is no method of two
// parents, the children are copies.
std::vector<const BreedingKind*> pairing_methods(const BreedingRegistry& methods,
                                                 std::size_t count) {
    std::vector<double> shares;
    for (const BreedingKind& method : methods.all())
        shares.push_back(method.parents > 1 && method.default_share > 0.0 ? 1.0 : 0.0);
    if (std::none_of(shares.begin(), shares.end(), [](double share) { return share > 0.0; }))
        return std::vector<const BreedingKind*>(count, &single_parent_method(methods));
    const std::vector<std::size_t> counts = largest_remainder(shares, count);
    std::vector<const BreedingKind*> chosen;
    for (std::size_t i = 0; i < counts.size(); ++i)
        chosen.insert(chosen.end(), counts[i], &methods[i]);
    return chosen;
}

// Makes the candidates one after the other, each from its own random streams.
class Breeder {
public:
    Breeder(const CandidateOrder& order, const ExperimentSettings& settings,
            const EvolutionKinds& kinds)
        : order_(order),
          settings_(with_picking_seed(settings)),
          kinds_(kinds),
          next_child_(static_cast<std::uint64_t>(order.round) * kCandidatesPerCell *
                      static_cast<std::uint64_t>(order.cells)) {}

    IndividualPtr copy(std::size_t parent) {
        RandomStream stream = breeding_stream();
        return child(parent, parent, single_parent_method(kinds_.breeding), stream);
    }
    IndividualPtr pair(const BreedingKind& method) {
        RandomStream stream = breeding_stream();
        const std::size_t first = stream.below(order_.parents.size());
        const std::size_t other = stream.below(order_.parents.size() - 1);
        return child(first, other < first ? other : other + 1, method, stream);
    }
    IndividualPtr immigrant() {
        return make_immigrant(settings_, kinds_, order_.node, next_child_++);
    }

private:
    RandomStream breeding_stream() const {
        return RandomStream(
            stream_seed(settings_.seed, order_.node, next_child_, Purpose::kPicking));
    }
    IndividualPtr child(std::size_t first, std::size_t second, const BreedingKind& method,
                        RandomStream& stream) {
        return make_child(
            {order_.parents[first], order_.parents[second], method, order_.extra_mutations},
            settings_, kinds_, order_.node, next_child_++, stream);
    }

    const CandidateOrder& order_;
    ExperimentSettings settings_;
    const EvolutionKinds& kinds_;
    std::uint64_t next_child_;
};

}  // namespace

CandidatePlan plan_candidates(std::size_t parents, int cells, int immigrant_cells) {
    const std::size_t all = kCandidatesPerCell * static_cast<std::size_t>(cells);
    if (parents == 0) return {.immigrants = all};
    const std::size_t immigrants = kCandidatesPerCell * static_cast<std::size_t>(immigrant_cells);
    const std::size_t offspring = all - immigrants;
    if (parents == 1) return {.copies = offspring, .immigrants = immigrants};
    return {.copies = kCopiesEach,
            .paired = offspring - kCopiesEach * parents,
            .immigrants = immigrants};
}

Candidates breed_candidates(const CandidateOrder& order, const ExperimentSettings& settings,
                            const EvolutionKinds& kinds) {
    const CandidatePlan plan =
        plan_candidates(order.parents.size(), order.cells, order.immigrant_cells);
    Breeder breeder(order, settings, kinds);
    Candidates candidates;
    for (std::size_t parent = 0; parent < order.parents.size(); ++parent) {
        for (std::size_t i = 0; i < plan.copies; ++i)
            candidates.offspring.push_back(breeder.copy(parent));
    }
    for (const BreedingKind* method : pairing_methods(kinds.breeding, plan.paired))
        candidates.offspring.push_back(breeder.pair(*method));
    for (std::size_t i = 0; i < plan.immigrants; ++i)
        candidates.immigrants.push_back(breeder.immigrant());
    return candidates;
}

std::uint64_t picking_seed(const ExperimentSettings& settings) {
    return stream_seed({settings.seed, static_cast<std::uint64_t>(Purpose::kPicking)});
}

std::vector<IndividualPtr> import_creatures(std::span<const GenomePtr> genomes, std::uint32_t node,
                                            const ExperimentSettings& settings) {
    const ExperimentSettings seeded = with_picking_seed(settings);
    std::vector<IndividualPtr> creatures;
    for (const GenomePtr& genome : genomes) {
        creatures.push_back(std::make_shared<const Individual>(
            make_individual(genome, seeded, node, kFirstImported + creatures.size(), "imported")));
    }
    return creatures;
}

}  // namespace cambrian
