#include "studio/experiment/timeline_plots.h"

#include <cstddef>

namespace cambrian {
namespace {

using Statistics = GenerationStatistics;

template <auto Field>
double field(const Statistics& row) {
    return static_cast<double>(row.*Field);
}

double invalid_percent(const Statistics& row) {
    return 100.0 * row.invalid_share;
}

}  // namespace

std::span<const TimelinePlot> timeline_plots() {
    static const std::vector<TimelinePlot> plots = {
        {TimelineQuantity::kFitness,
         "fitness",
         "Fitness",
         "The best creature of each generation, the median, and the band from 10 to 90 %.",
         {{"best", field<&Statistics::best>}, {"median", field<&Statistics::median>}},
         field<&Statistics::lower>,
         field<&Statistics::upper>},
        {TimelineQuantity::kDiversity,
         "diversity",
         "Diversity",
         "The numbers of different genomes, and of cells with a creature on the map of body kinds.",
         {{"distinct genomes", field<&Statistics::distinct_genomes>},
          {"filled cells", field<&Statistics::filled_cells>}}},
        {TimelineQuantity::kKinds,
         "kinds",
         "Lineages",
         "The numbers of founders from which the survivors of each generation descend through "
         "mothers, and of their body plans.",
         {{"founder lines", field<&Statistics::lines>}, {"body plans", field<&Statistics::plans>}}},
        {TimelineQuantity::kLines,
         "lines",
         "Births by line",
         "The number of each founder's descendants through mothers in each generation. Every line "
         "has a band, those with most births at the bottom; the others together are grey.",
         {},
         nullptr,
         nullptr,
         true},
        {TimelineQuantity::kParts,
         "parts",
         "Parts",
         "The number of parts of a body, on average over the generation.",
         {{"parts, mean", field<&Statistics::mean_parts>}}},
        {TimelineQuantity::kNeurons,
         "neurons",
         "Neurons",
         "The number of connected neurons of a brain, on average over the generation.",
         {{"neurons, mean", field<&Statistics::mean_neurons>}}},
        {TimelineQuantity::kTrials,
         "trials",
         "Trials",
         "The numbers of trials that were run for each generation, with those that confirm scores, "
         "and of scores known from an equal genome.",
         {{"run", field<&Statistics::evaluations>}, {"known already", field<&Statistics::reused>}}},
        {TimelineQuantity::kInvalid,
         "invalid",
         "Invalid",
         "The share of creatures whose trial is invalid.",
         {{"invalid, %", invalid_percent}}},
        {TimelineQuantity::kTerrainLevel,
         "level",
         "Terrain level",
         "The share of the terrain's height, gaps and slope that was in force, which a ladder "
         "raises.",
         {{"terrain level", field<&Statistics::terrain_level>}}},
    };
    return plots;
}

const TimelinePlot& timeline_plot(TimelineQuantity quantity) {
    return timeline_plots()[static_cast<std::size_t>(quantity)];
}

std::string goal_in(const EvolutionSnapshot& snapshot, std::uint32_t generation) {
    const auto& champions = snapshot.champions;
    const auto found = std::lower_bound(champions.begin(), champions.end(), generation,
                                        [](const JudgedIndividual& each, std::uint32_t wanted) {
                                            return each.generation < wanted;
                                        });
    const bool known = found != champions.end() && found->generation == generation;
    if (known) return found->settings->goal;
    return snapshot.settings == nullptr ? std::string() : snapshot.settings->goal;
}

}  // namespace cambrian
