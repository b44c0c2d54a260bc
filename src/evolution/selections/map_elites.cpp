// MAP-Elites (Mouret & Clune 2015), evolution/README.md 2. The fittest creature of every cell of a
// map survives and breeds in proportion to 0.1 + f / f_best; there are as many children as the
// population's size. The survivors are the archive. A child takes a cell if the cell is empty or
// the child is strictly fitter.
#include "evolution/individual/map_axis.h"
#include "evolution/selections/survival.h"

#include <algorithm>
#include <map>
#include <utility>

namespace cambrian {
namespace {

constexpr double kLeastShare = 0.1;

bool takes_over(const Individual& challenger, const Individual& holder) {
    if (challenger.result.fitness != holder.result.fitness)
        return fitter(challenger.result, holder.result);
    if (challenger.born != holder.born) return challenger.born < holder.born;
    return challenger.uid < holder.uid;
}

// Returns the fittest of each cell, in the order of the ranking; the very best if no cell is
// filled.
std::vector<std::size_t> elites_of(std::span<const IndividualPtr> ranked,
                                   const ExperimentSettings& settings) {
    std::map<MapCell, std::size_t> holders;
    for (std::size_t i = 0; i < ranked.size(); ++i) {
        if (ranked[i]->result.outcome != Outcome::kCompleted) continue;
        const auto [cell, is_new] = holders.try_emplace(cell_of(ranked[i]->result, settings), i);
        if (!is_new && takes_over(*ranked[i], *ranked[cell->second])) cell->second = i;
    }
    std::vector<std::size_t> elites;
    elites.reserve(holders.size());
    for (const auto& [cell, holder] : holders)
        elites.push_back(holder);
    std::sort(elites.begin(), elites.end());
    if (elites.empty()) elites.push_back(0);
    return elites;
}

SelectionResult select_by_map(std::span<const IndividualPtr> ranked,
                              const ExperimentSettings& settings, SelectionMemory& /*memory*/,
                              RandomStream& stream) {
    std::vector<std::size_t> elites = elites_of(ranked, settings);
    const double best = ranked[elites.front()]->result.fitness;
    std::vector<double> weights(ranked.size(), 0.0);
    for (const std::size_t elite : elites) {
        const double fitness = std::max(ranked[elite]->result.fitness, 0.0);
        weights[elite] = kLeastShare + (best > 0.0 ? fitness / best : 0.0);
    }
    return breed_whole_batch(std::move(elites), std::move(weights), settings, stream);
}

void add_map_settings(SelectionRows& rows) {
    std::vector<std::string> axes;
    for (const MapAxis& axis : map_axes())
        axes.emplace_back(axis.id);
    rows.table
        .choice(&SelectionSettings::map_across, "map-across", "Map, across", axes,
                "The first of two quantities in which kinds of creatures differ.")
        .applies = rows.in_force;
    rows.table
        .choice(&SelectionSettings::map_up, "map-up", "Map, up", axes,
                "The second of two quantities in which kinds of creatures differ.")
        .applies = rows.in_force;
}

}  // namespace

void add_map_elites(SelectionRegistry& selections) {
    selections.add(
        {.id = "map-elites",
         .label = "MAP-Elites",
         .help = "Many kinds: the fittest creature of every kind of body survives and breeds.",
         .fills_map = true,
         .add_settings = add_map_settings,
         .select = select_by_map});
}

}  // namespace cambrian
