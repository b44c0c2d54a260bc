#pragma once

#include "evolution/engine/snapshot.h"
#include "studio/experiment/timeline_plots.h"
#include "studio/widgets/plot.h"

#include <string>
#include <vector>

namespace cambrian {

// One quantity over the generations, in the panel or in a picture.
class TimelineChart {
public:
    // Adds new generations; cheap if there are none.
    void gather(const EvolutionSnapshot& snapshot, TimelineQuantity quantity);
    bool empty() const { return generations_.empty(); }
    // Fits all generations and values into an area; not while empty.
    PlotScale scale_for(const Rect& area) const;
    void draw(ImDrawList& list, const PlotScale& scale) const;
    // Marks on the curves at a row of the history.
    void draw_dots(ImDrawList& list, const PlotScale& scale, std::size_t row) const;
    // The row of the history whose generation is nearest to a pixel.
    std::size_t row_at(const PlotScale& scale, float pixel) const;
    double generation(std::size_t row) const { return generations_[row]; }

private:
    void forget();
    void stack(const EvolutionSnapshot& snapshot);

    std::uint64_t experiment_ = 0;
    const TimelinePlot* plot_ = &timeline_plot(TimelineQuantity::kFitness);
    std::vector<double> generations_;
    std::vector<std::vector<double>> curves_;
    std::vector<double> lower_;
    std::vector<double> upper_;
    // Upper edges of the bands of births by line, from the bottom; the last is of all others.
    std::vector<std::vector<double>> bands_;
};

// "Fitness in m"; unit: of the goal.
std::string timeline_title(const TimelinePlot& plot, const std::string& unit);
// Names of the curves beside their colours, ending at the right; the width it takes if not drawn.
float legend_width(const TimelinePlot& plot);
void draw_legend(ImDrawList& list, const TimelinePlot& plot, const ImVec2& right_top);
// Where settings changed.
void draw_change_marks(ImDrawList& list, const PlotScale& scale, const EvolutionSnapshot& snapshot);

// The chart as a picture of its own, with its title and legend.
void draw_timeline_picture(ImDrawList& list, const Rect& area, const EvolutionSnapshot& snapshot,
                           TimelineQuantity quantity, const std::string& unit);

}  // namespace cambrian
