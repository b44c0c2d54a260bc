#include "studio/hand_picking/grid_motion.h"

#include "studio/playback/playback.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr int kTicksAJob = 60;

}  // namespace

// Expresses a creature and runs its trial in pieces. Only one thread at a time may use it.
struct GridMotion::Recorder {
    GenomePtr genome;
    ExpressionSettings expression;
    TrialWorld world;
    std::shared_ptr<const Phenotype> phenotype;
    std::unique_ptr<Trial> trial;
    std::size_t recorded = 0;  // number of frames recorded so far
    bool complete = false;

    void begin(const Kinds& kinds) {
        phenotype =
            std::make_shared<const Phenotype>(express(*genome, kinds, expression, world.scene));
        if (auto started = Trial::start(phenotype, kinds, world)) trial = std::move(*started);
        complete = trial == nullptr;
    }
    std::vector<MotionFrame> run(const Kinds& kinds, const std::stop_token& stop) {
        if (!phenotype) begin(kinds);
        std::vector<MotionFrame> frames;
        while (!complete && frames.size() < kTicksAJob && !stop.stop_requested()) {
            const bool going_on = trial->tick();
            complete = !going_on || static_cast<double>(recorded) * kBrainTick >= kLongestLoop;
            if (trial->settling() && !complete) continue;
            frames.push_back(motion_frame(*trial));
            ++recorded;
        }
        return frames;
    }
};

void GridMotion::show(const std::vector<IndividualPtr>& creatures,
                      const ExpressionSettings& expression, const TrialWorld& world) {
    ++shown_;
    world_ = with_drawn_ground(world);
    time_ = 0.0;
    cells_.assign(creatures.size(), {});
    for (std::size_t i = 0; i < creatures.size(); ++i) {
        auto recorder = std::make_shared<Recorder>();
        recorder->genome = creatures[i]->genome;
        recorder->expression = expression;
        recorder->world = world;
        record_on(i, std::move(recorder));
    }
}

void GridMotion::record_on(std::size_t cell, std::shared_ptr<Recorder> recorder) {
    worker_.submit(
        [this, cell, shown = shown_, recorder = std::move(recorder)](const std::stop_token& stop) {
            auto frames = recorder->run(kinds_, stop);
            return [this, cell, shown, recorder, frames = std::move(frames)]() mutable {
                if (shown != shown_) return;
                RecordedMotion& motion = cells_[cell];
                motion.phenotype = recorder->phenotype;
                for (MotionFrame& frame : frames) {
                    if (!motion.empty())
                        add_scuffs(motion.scuffs, motion.phenotype->plan, motion.frames.size(),
                                   motion.frames.back(), frame, world_.environment.has_ground);
                    motion.frames.push_back(std::move(frame));
                }
                motion.complete = recorder->complete;
                if (!motion.complete) record_on(cell, recorder);
            };
        });
}

void GridMotion::advance(double elapsed) {
    worker_.deliver();
    time_ = std::min(time_ + std::min(elapsed, kLongestGap), recorded());
    double loop = 0.0;
    for (const RecordedMotion& motion : cells_)
        loop = std::max(loop, motion.length());
    if (complete() && time_ >= loop) time_ = 0.0;
}

bool GridMotion::complete() const {
    return std::all_of(cells_.begin(), cells_.end(),
                       [](const RecordedMotion& motion) { return motion.complete; });
}

// Returns the time up to which every motion is computed, in s.
double GridMotion::recorded() const {
    double known = kLongestLoop;
    for (const RecordedMotion& motion : cells_) {
        if (!motion.complete) known = std::min(known, motion.length());
    }
    return known;
}

}  // namespace cambrian
