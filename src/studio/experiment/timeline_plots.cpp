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
         "Genomes that differ, and cells of the map of body kinds with a creature in them.",
         {{"distinct genomes", field<&Statistics::distinct_genomes>},
          {"filled cells", field<&Statistics::filled_cells>}}},
        {TimelineQuantity::kKinds,
         "kinds",
         "Kinds",
         "Founders that the survivors of each generation descend from, by mothers, and body plans "
         "that they have.",
         {{"founder lines", field<&Statistics::lines>}, {"body plans", field<&Statistics::plans>}}},
        {TimelineQuantity::kLines,
         "lines",
         "Births by line",
         "How many creatures of each generation descend from which founder, by mothers: a band a "
         "line, those with most births at the bottom; the others together are grey.",
         {},
         nullptr,
         nullptr,
         true},
        {TimelineQuantity::kParts,
         "parts",
         "Parts",
         "Parts of a body, on average over the generation.",
         {{"parts, mean", field<&Statistics::mean_parts>}}},
        {TimelineQuantity::kNeurons,
         "neurons",
         "Neurons",
         "Live neurons of a brain, on average over the generation.",
         {{"neurons, mean", field<&Statistics::mean_neurons>}}},
        {TimelineQuantity::kTrials,
         "trials",
         "Trials",
         "Trials that were run for each generation, those that confirm scores among them, and "
         "scores known from an equal genome.",
         {{"run", field<&Statistics::evaluations>}, {"known already", field<&Statistics::reused>}}},
        {TimelineQuantity::kInvalid,
         "invalid",
         "Invalid",
         "Creatures without a motion that can be judged, in percent of the generation.",
         {{"invalid, %", invalid_percent}}},
    };
    return plots;
}

const TimelinePlot& timeline_plot(TimelineQuantity quantity) {
    return timeline_plots()[static_cast<std::size_t>(quantity)];
}

}  // namespace cambrian
