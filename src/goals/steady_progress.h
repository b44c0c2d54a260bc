#pragma once

// Progress over ground that falls, launches and single hops do not make (goals/README.md 1).

#include "goals/sampling.h"

#include <algorithm>
#include <array>

namespace cambrian {

// Ends of the windows, as shares of the trial. The first fifth is ignored.
inline constexpr std::array<double, 5> kProgressSeams = {0.2, 0.4, 0.6, 0.8, 1.0};

struct SteadyProgress {
    double all = 0.0;      // m
    double slowest = 0.0;  // m, of the window with the least progress

    // Returns 0.3 times the total and 0.7 times that of four windows as slow as the slowest, in m.
    double credit() const {
        constexpr double kShareOfAll = 0.3;
        constexpr double kWindows = 4.0;
        return kShareOfAll * all + (1.0 - kShareOfAll) * kWindows * slowest;
    }
};

// Returns the time that counts, in s.
inline double scored_time(const TrialRecord& record) {
    return (1.0 - kProgressSeams.front()) * record.duration;
}

// Returns the coordinate of the trailing edge, in m, in +x (direction 1) or -x (direction -1).
inline double trailing_edge(const MotionSample& sample, int direction) {
    return direction > 0 ? sample.bounds.low.x() : -sample.bounds.high.x();
}

// Returns the progress of an edge, whose coordinate at a sample's index is given.
template <class Edge>
SteadyProgress progress_of(const TrialRecord& record, Edge edge) {
    SteadyProgress progress;
    double before = edge(sample_index(record, kProgressSeams.front()));
    for (std::size_t i = 1; i < kProgressSeams.size(); ++i) {
        const double now = edge(sample_index(record, kProgressSeams[i]));
        const double moved = now - before;
        progress.all += moved;
        progress.slowest = i == 1 ? moved : std::min(progress.slowest, moved);
        before = now;
    }
    return progress;
}

inline SteadyProgress progress_towards(const TrialRecord& record, int direction) {
    return progress_of(record, [&](std::size_t sample) {
        return trailing_edge(record.samples[sample], direction);
    });
}

}  // namespace cambrian
