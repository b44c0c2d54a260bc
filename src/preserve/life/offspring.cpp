#include "preserve/life/offspring.h"

#include "evolution/generation.h"

#include <memory>

namespace cambrian {
namespace {

const BreedingKind& draw_method(const Genome& genome, const ExperimentSettings& settings,
                                const EvolutionKinds& kinds, RandomStream& stream) {
    std::vector<double> shares;
    for (const BreedingKind& kind : kinds.breeding.all()) {
        const auto set = settings.breeding.shares.find(kind.id);
        shares.push_back(set == settings.breeding.shares.end() ? kind.default_share : set->second);
    }
    const BreedingKind& drawn = kinds.breeding[stream.weighted(shares)];
    if (settings.breeding.choice != "attribute") return drawn;
    const BreedingKind* own =
        kinds.breeding.find(kinds.creature.catalog.reproductions[genome.reproduction]);
    return own == nullptr ? drawn : *own;
}

// Returns the nearest grown creature within the distance of mates, or null.
const Resident* nearest_mate(const Resident& parent, const Residents& all,
                             const ExperimentSettings& settings, std::uint64_t tick) {
    const PreserveSettings& laws = settings.preserve;
    const Torus torus = area_of(laws, settings.world.environment).torus();
    const Resident* nearest = nullptr;
    double least = laws.mate_distance;
    for (const auto& other : all) {
        if (other.get() == &parent || other->age(tick) < laws.birth_interval) continue;
        const double distance = torus.shortest(other->center() - parent.center()).norm();
        if (distance > least || (nearest != nullptr && distance == least)) continue;
        nearest = other.get();
        least = distance;
    }
    return nearest;
}

IndividualPtr individual_of(const Resident& resident, const ExperimentSettings& settings) {
    return std::make_shared<const Individual>(make_individual(
        resident.genome(), settings, 0, resident.life.number, resident.life.method));
}

}  // namespace

Life conceive(const Resident& parent, const Residents& all, const ExperimentSettings& settings,
              const EvolutionKinds& kinds, std::uint64_t attempt, std::uint64_t tick,
              RandomStream& stream) {
    const IndividualPtr first = individual_of(parent, settings);
    const BreedingKind* method = &draw_method(*first->genome, settings, kinds, stream);
    const Resident* mate =
        method->parents > 1 ? nearest_mate(parent, all, settings, tick) : nullptr;
    if (mate == nullptr && method->parents > 1) method = &single_parent_method(kinds.breeding);
    const IndividualPtr second = mate == nullptr ? first : individual_of(*mate, settings);
    const IndividualPtr child =
        make_child({first, second, *method}, settings, kinds, 0, attempt, stream);
    return {.uid = child->uid,
            .parents = {parent.life.number, mate == nullptr ? 0 : mate->life.number},
            .method = child->method,
            .mutations = static_cast<std::uint32_t>(child->mutations.size()),
            .genome = child->genome,
            .born = tick};
}

}  // namespace cambrian
