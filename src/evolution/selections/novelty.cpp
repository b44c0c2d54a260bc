// Novelty with local competition (Lehman & Stanley 2011), evolution/README.md 2. A creature is
// described by (log mass, settled height, movable joints), each in standard deviations over
// population and archive. Novelty is the mean distance to its nearest neighbours among both; the
// local score is the number of them that it beats. Parents and as many children compete for the
// places by non-dominated sorting on the two. The fittest of all always keeps a place, so that the
// best is never lost.
//
// Offspring more novel than a threshold join the archive; the threshold grows by 20 % after a
// generation with more than four and falls by 5 % after ten generations with none.
#include "evolution/selections/nearest_neighbors.h"
#include "evolution/selections/pareto.h"
#include "evolution/selections/survival.h"
#include "math/elementary.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace cambrian {
namespace {

constexpr double kLightest = 1e-6;  // kg; least mass, since its logarithm is taken
constexpr int kMany = 4;
constexpr double kHarder = 1.2;
constexpr int kQuiet = 10;  // generations without a new member after which the threshold falls
constexpr double kEasier = 0.95;

constexpr KindParameter<int> kNeighbors{"novelty-neighbors", 15};
constexpr KindParameter<double> kThreshold{"novelty-threshold", 1.0};  // standard deviations

using Description = NeighborSearch::Point;

Description describe(const Individual& individual) {
    const EvaluationResult& result = individual.result;
    return {logarithm(std::fmax(result.mass, kLightest)), result.behavior.settled_height,
            static_cast<double>(result.behavior.movable_joints)};
}

// Converts values to standard deviations. A measure that is equal for all is left out.
void standardize(std::vector<Description>& all) {
    const double count = static_cast<double>(all.size());
    for (std::size_t measure = 0; measure < Description().size(); ++measure) {
        double mean = 0.0;
        for (const Description& each : all)
            mean += each[measure] / count;
        double variance = 0.0;
        for (const Description& each : all)
            variance += (each[measure] - mean) * (each[measure] - mean) / count;
        const double scale = variance > 0.0 ? 1.0 / std::sqrt(variance) : 0.0;
        for (Description& each : all)
            each[measure] = (each[measure] - mean) * scale;
    }
}

// Returns the population, followed by those of the archive that no longer live.
std::vector<IndividualPtr> with_archive(std::span<const IndividualPtr> population,
                                        const SelectionMemory& memory) {
    std::vector<IndividualPtr> all(population.begin(), population.end());
    std::set<std::uint64_t> living;
    for (const IndividualPtr& individual : population)
        living.insert(individual->uid);
    for (const IndividualPtr& individual : memory.archive) {
        if (living.count(individual->uid) == 0) all.push_back(individual);
    }
    return all;
}

// Returns novelty and local score of all creatures of the population.
std::vector<ParetoPoint> judge_novelty(std::span<const IndividualPtr> population,
                                       const SelectionMemory& memory, int neighbors) {
    const std::vector<IndividualPtr> all = with_archive(population, memory);
    std::vector<Description> descriptions;
    descriptions.reserve(all.size());
    for (const IndividualPtr& individual : all)
        descriptions.push_back(describe(*individual));
    standardize(descriptions);
    const std::size_t near = std::min(static_cast<std::size_t>(neighbors), all.size() - 1);
    std::vector<ParetoPoint> points(population.size());
    NeighborSearch search(descriptions);
    for (std::size_t i = 0; i < population.size() && near > 0; ++i) {
        for (const Neighbor& other : search.nearest(i, near)) {
            points[i].first += other.distance / static_cast<double>(near);
            const bool beaten = fitter(population[i]->result, all[other.point]->result);
            points[i].second += beaten ? 1.0 : 0.0;
        }
    }
    return points;
}

void update_archive(std::span<const IndividualPtr> population, std::span<const ParetoPoint> points,
                    double first_threshold, SelectionMemory& memory) {
    if (!(memory.threshold > 0.0)) memory.threshold = first_threshold;
    std::uint32_t newest = 0;
    for (const IndividualPtr& individual : population)
        newest = std::max(newest, individual->born);
    int added = 0;
    for (std::size_t i = 0; i < population.size(); ++i) {
        if (population[i]->born != newest || points[i].first <= memory.threshold) continue;
        memory.archive.push_back(population[i]);
        ++added;
    }
    memory.quiet_generations = added > 0 ? 0 : memory.quiet_generations + 1;
    if (added > kMany) memory.threshold *= kHarder;
    if (memory.quiet_generations >= kQuiet) {
        memory.threshold *= kEasier;
        memory.quiet_generations = 0;
    }
}

std::vector<std::size_t> most_novel(std::span<const ParetoPoint> points, std::size_t wanted) {
    std::vector<std::size_t> kept = pareto_order(points);
    const auto best = std::find(kept.begin(), kept.end(), std::size_t{0});
    std::rotate(kept.begin(), best, best + 1);
    kept.resize(std::min(kept.size(), wanted));
    std::sort(kept.begin(), kept.end());
    return kept;
}

SelectionResult select_by_novelty(std::span<const IndividualPtr> ranked,
                                  const ExperimentSettings& settings, SelectionMemory& memory,
                                  RandomStream& stream) {
    const auto candidates = furthest(ranked);
    const auto points = judge_novelty(candidates, memory, kNeighbors.of(settings.selection.own));
    update_archive(candidates, points, kThreshold.of(settings.selection.own), memory);
    std::vector<std::size_t> survivors =
        most_novel(points, static_cast<std::size_t>(settings.population.size));
    std::vector<double> weights(ranked.size(), 0.0);
    for (const std::size_t survivor : survivors)
        weights[survivor] = 1.0;
    return breed_whole_batch(std::move(survivors), std::move(weights), settings, stream);
}

void add_novelty_settings(SelectionRows& rows) {
    rows.table
        .number(kNeighbors, kNeighbors.key, "Neighbors", "creatures", {1, 1000},
                "The number of most similar creatures against which novelty is measured.")
        .applies = rows.in_force;
    rows.table
        .number(kThreshold, kThreshold.key, "Novelty to be kept", "", {1e-3, 100},
                "The distance from other creatures, in standard deviations, from which on a "
                "creature is remembered as novel. This is the initial value; it adapts.")
        .applies = rows.in_force;
}

}  // namespace

void add_novelty(SelectionRegistry& selections) {
    selections.add(
        {.id = "novelty",
         .label = "Novelty",
         .help =
             "Creatures survive that differ from the others and are better than their neighbors.",
         .add_settings = add_novelty_settings,
         .select = select_by_novelty});
}

}  // namespace cambrian
