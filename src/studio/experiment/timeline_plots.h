#pragma once

// What the timeline can plot, each quantity as one or two curves over the generations.

#include "evolution/individual/statistics.h"
#include "studio/look/view_state.h"

#include <span>
#include <vector>

namespace cambrian {

using TimelineMeasure = double (*)(const GenerationStatistics& row);

struct TimelineCurve {
    const char* label;
    TimelineMeasure measure;
};

struct TimelinePlot {
    TimelineQuantity quantity;
    const char* id;    // in the remembered view
    const char* name;  // "Fitness"
    const char* what;  // a sentence
    std::vector<TimelineCurve> curves;
    TimelineMeasure lower = nullptr;  // of the band around the second curve, or null
    TimelineMeasure upper = nullptr;
    bool births_by_line = false;  // bands, one on the other, instead of curves
};

// One a quantity, in its order.
std::span<const TimelinePlot> timeline_plots();
const TimelinePlot& timeline_plot(TimelineQuantity quantity);

}  // namespace cambrian
