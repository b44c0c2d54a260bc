#include "studio/panels/generations/tile_list.h"

#include "math/distance.h"
#include "picking/grid/grid_choice.h"

#include <algorithm>
#include <array>
#include <set>

namespace cambrian {
namespace {

constexpr std::array kSortings = {
    TileSorting{TileOrder::kFitness, "fitness", "Fitness", "The fittest creatures first."},
    TileSorting{TileOrder::kAge, "age", "Age", "The creatures of the earliest generation first."},
    TileSorting{TileOrder::kParts, "parts", "Parts", "The creatures with the most parts first."},
    TileSorting{TileOrder::kMass, "mass", "Mass", "The heaviest creatures first."},
    TileSorting{TileOrder::kDifference, "difference", "Difference",
                "The creatures first that differ most from the average in parts, mass, height, "
                "joint frequency and distance."},
};

std::vector<Tile> tiles_of_generation(const EvolutionSnapshot& snapshot, const Stars& stars) {
    std::vector<Tile> tiles;
    if (snapshot.champions.empty()) return tiles;
    const JudgedIndividual& best = snapshot.champions.back();
    std::set<const Genome*> starred;
    for (const JudgedIndividual& each : stars.all())
        starred.insert(each.individual->genome.get());
    for (const IndividualPtr& individual : snapshot.population) {
        tiles.push_back({{best.generation, individual, best.settings},
                         tiles.size() + 1,
                         starred.count(individual->genome.get()) == 1});
    }
    return tiles;
}

// Starred creatures of the present generation keep their tile; those of past generations are added
// as they were when starred.
std::vector<Tile> tiles_with_star(std::vector<Tile> generation, const Stars& stars) {
    std::erase_if(generation, [](const Tile& tile) { return !tile.starred; });
    std::set<const Genome*> living;
    for (const Tile& tile : generation)
        living.insert(tile.creature.individual->genome.get());
    for (const JudgedIndividual& each : stars.all()) {
        if (living.count(each.individual->genome.get()) == 0) generation.push_back({each, 0, true});
    }
    return generation;
}

// Keeps the first tile of each body plan, which is the best of its generation.
void keep_one_a_plan(std::vector<Tile>& tiles) {
    std::set<std::uint64_t> plans;
    std::erase_if(tiles, [&plans](const Tile& tile) {
        return !plans.insert(tile.creature.individual->result.plan).second;
    });
}

double measure(const Individual& individual, TileOrder order) {
    switch (order) {
        case TileOrder::kAge:
            return -static_cast<double>(individual.born);
        case TileOrder::kParts:
            return individual.result.parts;
        case TileOrder::kMass:
            return individual.result.mass;
        case TileOrder::kFitness:  // not a number alone; see is_before()
        case TileOrder::kDifference:
            break;
    }
    return 0.0;
}

// Computes the distance of each creature to the mean of all.
void measure_difference(std::vector<Tile>& tiles) {
    std::vector<IndividualPtr> all;
    for (const Tile& tile : tiles)
        all.push_back(tile.creature.individual);
    const std::vector<GridDescriptor> descriptors = scaled_descriptors(all);
    GridDescriptor mean = {};
    for (const GridDescriptor& each : descriptors) {
        for (std::size_t i = 0; i < mean.size(); ++i)
            mean[i] += each[i] / static_cast<double>(descriptors.size());
    }
    for (std::size_t i = 0; i < tiles.size(); ++i)
        tiles[i].key = distance(descriptors[i], mean);
}

bool is_before(const Tile& a, const Tile& b, TileOrder order) {
    if (order == TileOrder::kFitness)
        return fitter(a.creature.individual->result, b.creature.individual->result);
    return a.key > b.key;
}

}  // namespace

std::span<const TileSorting> tile_sortings() {
    return kSortings;
}

const TileSorting& tile_sorting(TileOrder order) {
    return kSortings[static_cast<std::size_t>(order)];
}

std::vector<Tile> list_tiles(const EvolutionSnapshot& snapshot, const Stars& stars, TileOrder order,
                             const TileFilter& filter) {
    std::vector<Tile> tiles = tiles_of_generation(snapshot, stars);
    if (filter.starred_only) tiles = tiles_with_star(std::move(tiles), stars);
    if (filter.one_a_plan) keep_one_a_plan(tiles);
    if (order == TileOrder::kFitness && !filter.starred_only) return tiles;
    for (Tile& tile : tiles)
        tile.key = measure(*tile.creature.individual, order);
    if (order == TileOrder::kDifference) measure_difference(tiles);
    std::stable_sort(tiles.begin(), tiles.end(),
                     [order](const Tile& a, const Tile& b) { return is_before(a, b, order); });
    return tiles;
}

}  // namespace cambrian
