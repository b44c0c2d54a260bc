#pragma once

// How the creatures of a grid move: the trial of each, computed in the background ahead of being
// shown, so that no frame waits for it; shown all by one clock, again and again.

#include "evolution/individual/individual.h"
#include "pictures/motion/recorded_motion.h"
#include "simulator/trial.h"
#include "studio/background/background_worker.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace cambrian {

inline constexpr double kLongestLoop = 12.0;  // s; longer trials begin again then

class GridMotion {
public:
    // kinds must outlive it.
    explicit GridMotion(const Kinds& kinds) : kinds_(kinds) {}

    // These creatures take the cells, from the start of their trials in this world.
    void show(const std::vector<IndividualPtr>& creatures, const ExpressionSettings& expression,
              const TrialWorld& world);
    // Once a frame. The clock waits for motion that is not computed yet.
    void advance(double elapsed);
    void restart() { time_ = 0.0; }

    std::size_t size() const { return cells_.size(); }
    const RecordedMotion& cell(std::size_t index) const { return cells_[index]; }
    const Environment& environment() const { return world_.environment; }
    double time() const { return time_; }  // s, of the clock all share

private:
    struct Recorder;

    void record_on(std::size_t cell, std::shared_ptr<Recorder> recorder);
    double recorded() const;
    bool complete() const;

    const Kinds& kinds_;
    TrialWorld world_;
    std::vector<RecordedMotion> cells_;
    double time_ = 0.0;
    unsigned shown_ = 0;  // counts grids, to know whose motion arrives
    BackgroundWorker worker_;
};

}  // namespace cambrian
