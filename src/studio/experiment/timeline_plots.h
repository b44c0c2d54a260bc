#pragma once

// The quantities that the timeline can plot, each as one or two curves over the generations.

#include "evolution/engine/snapshot.h"
#include "evolution/individual/statistics.h"
#include "studio/look/view_state.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace cambrian {

using TimelineMeasure = double (*)(const GenerationStatistics& row);

struct TimelineCurve {
    const char* label;
    TimelineMeasure measure;
};

struct TimelinePlot {
    TimelineQuantity quantity;
    const char* id;    // name in the stored view state
    const char* name;  // "Fitness"
    const char* what;  // description, one sentence
    std::vector<TimelineCurve> curves;
    TimelineMeasure lower = nullptr;  // lower edge of the band around the second curve, or null
    TimelineMeasure upper = nullptr;
    // Whether it draws stacked bands of births per founder line instead of curves.
    bool births_by_line = false;
};

// Returns one plot for each TimelineQuantity, in its order.
std::span<const TimelinePlot> timeline_plots();
const TimelinePlot& timeline_plot(TimelineQuantity quantity);

// Returns the goal by which a finished generation was judged, which may have changed since.
std::string goal_in(const EvolutionSnapshot& snapshot, std::uint32_t generation);

}  // namespace cambrian
