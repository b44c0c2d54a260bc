#pragma once

// The motion of the creatures of a grid. Each trial is computed in the background ahead of display,
// so that no frame waits for it. All cells share one clock and repeat their motion.

#include "evolution/individual/individual.h"
#include "pictures/motion/recorded_motion.h"
#include "simulator/trial.h"
#include "studio/background/background_worker.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace cambrian {

inline constexpr double kLongestLoop = 12.0;  // s; longer trials are cut off here and repeat

class GridMotion {
public:
    // `kinds` must outlive the object.
    explicit GridMotion(const Kinds& kinds) : kinds_(kinds) {}

    // Fills the cells with these creatures and starts their trials in this world.
    void show(const std::vector<IndividualPtr>& creatures, const ExpressionSettings& expression,
              const TrialWorld& world);
    // Must be called once a frame. The clock waits for motion that is not computed yet.
    void advance(double elapsed);
    void restart() { time_ = 0.0; }

    std::size_t size() const { return cells_.size(); }
    const RecordedMotion& cell(std::size_t index) const { return cells_[index]; }
    const Environment& environment() const { return world_.environment; }
    double time() const { return time_; }  // s; the clock that all cells share

private:
    struct Recorder;

    void record_on(std::size_t cell, std::shared_ptr<Recorder> recorder);
    double recorded() const;
    bool complete() const;

    const Kinds& kinds_;
    TrialWorld world_;
    std::vector<RecordedMotion> cells_;
    double time_ = 0.0;
    // The number of grids shown so far, which identifies the grid that arriving motion belongs to.
    unsigned shown_ = 0;
    BackgroundWorker worker_;
};

}  // namespace cambrian
