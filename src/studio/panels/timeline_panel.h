#pragma once

#include "studio/panel.h"
#include "studio/plot.h"

#include <vector>

namespace cambrian {

// Fitness over the generations: best, median and the band from 10 to 90 %, marks where settings
// changed, values under the mouse; a click or drag shows that generation's champion.
class TimelinePanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    void gather(const EvolutionSnapshot& snapshot);
    PlotScale scale_for(const Rect& area) const;
    void draw_curves(const PlotScale& scale) const;
    void draw_changes(const PlotScale& scale, const EvolutionSnapshot& snapshot) const;
    void handle_mouse(const PlotScale& scale, const FrameContext& frame, Requests& out) const;

    // Columns of the plot, refilled when a generation is added.
    std::uint64_t experiment_ = 0;
    std::vector<double> generations_;
    std::vector<double> best_;
    std::vector<double> upper_;
    std::vector<double> median_;
    std::vector<double> lower_;
};

}  // namespace cambrian
