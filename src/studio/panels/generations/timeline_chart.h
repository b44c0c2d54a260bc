#pragma once

#include "evolution/engine/snapshot.h"
#include "goals/goal.h"
#include "studio/experiment/timeline_plots.h"
#include "studio/widgets/plot.h"

#include <string>
#include <vector>

namespace cambrian {

// Plots one quantity over the generations, in the panel or in a picture.
class TimelineChart {
public:
    // Adds new generations; takes little time if there are none.
    void gather(const EvolutionSnapshot& snapshot, TimelineQuantity quantity);
    bool empty() const { return generations_.empty(); }
    // Returns the scale that fits all generations, and the values of those with the last goal, into
    // an area; must not be called while empty().
    PlotScale scale_for(const Rect& area) const;
    // Each goal has a piece of the curve on a scale of its own, since its unit is another one.
    void draw(ImDrawList& list, const PlotScale& scale) const;
    // Draws where the pieces begin, with their goals and units, if there are several.
    void draw_goals(ImDrawList& list, const PlotScale& scale, const GoalRegistry& goals) const;
    std::size_t piece_count() const { return pieces_.size(); }
    // Returns the scale of the piece that a row of the history belongs to.
    PlotScale scale_at(const PlotScale& scale, std::size_t row) const;
    // Marks the curves' points of one row of the history.
    void draw_dots(ImDrawList& list, const PlotScale& scale, std::size_t row) const;
    // Returns the row of the history whose generation is nearest to a pixel.
    std::size_t row_at(const PlotScale& scale, float pixel) const;
    double generation(std::size_t row) const { return generations_[row]; }

private:
    // Rows of the history that were judged by one goal.
    struct Piece {
        std::string goal;
        std::size_t first = 0;
        std::size_t end = 0;
    };
    void forget();
    PlotScale scale_of(const PlotScale& scale, const Piece& piece) const;
    void stack(const EvolutionSnapshot& snapshot);

    std::uint64_t experiment_ = 0;
    const TimelinePlot* plot_ = &timeline_plot(TimelineQuantity::kFitness);
    std::vector<double> generations_;
    std::vector<Piece> pieces_;
    std::vector<std::vector<double>> curves_;
    std::vector<double> lower_;
    std::vector<double> upper_;
    // Upper edges of the bands of births per founder line, from the bottom; the last band is all
    // other lines.
    std::vector<std::vector<double>> bands_;
};

// Returns a title such as "Fitness in m"; `unit` is the goal's.
std::string timeline_title(const TimelinePlot& plot, const std::string& unit);
// draw_legend() draws the curves' names beside their colours, aligned at the right; legend_width()
// returns its width.
float legend_width(const TimelinePlot& plot);
void draw_legend(ImDrawList& list, const TimelinePlot& plot, const ImVec2& right_top);
// Marks the generations at which settings changed.
void draw_change_marks(ImDrawList& list, const PlotScale& scale, const EvolutionSnapshot& snapshot);

// Draws the chart as a separate picture with its title and legend.
void draw_timeline_picture(ImDrawList& list, const Rect& area, const EvolutionSnapshot& snapshot,
                           TimelineQuantity quantity, const GoalRegistry& goals);

}  // namespace cambrian
