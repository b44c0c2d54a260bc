#pragma once

// A trial as moments to draw, so that any of them can be drawn in any order.

#include "core/result.h"
#include "pictures/touched_faces.h"
#include "simulator/trial.h"
#include "simulator/trial_watch.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace cambrian {

struct MotionFrame {
    std::vector<Pose> poses;  // of the parts
    Vec3 center_of_mass = Vec3::Zero();
    std::vector<FaceSet> touched;  // of each part
};

// The body as it is.
MotionFrame motion_frame(const BodyView& body);

// One creature's trial from the end of settling on. Every tick of 1/60 s is a frame, unless that
// would be too much to keep: then every second one, every fourth...
struct RecordedMotion {
    std::shared_ptr<const Phenotype> phenotype;  // null until grown
    std::vector<MotionFrame> frames;
    std::size_t stride = 1;     // ticks from one frame to the next
    std::size_t ticks = 0;      // after the first frame, where not every one is a frame
    std::vector<Vec2> centers;  // of mass, of every fourth tick; where not every tick is a frame
    bool complete = false;

    bool empty() const { return frames.empty(); }
    double length() const;  // s
    // Between two frames, where every tick is one, or else the last frame before; the last one
    // from its end on. Not of an empty one.
    MotionFrame at(double time) const;
    // Where the centre of mass was up to then, oldest first, fifteen a second, at most so many.
    std::vector<Vec2> trail(double time, std::size_t most) const;
};

// Of frames kept of one motion.
inline constexpr std::size_t kMostMotion = 48'000'000;  // bytes

struct RecordedTrial {
    RecordedMotion motion;  // to where the test phase ended; at least its start
    TrialRecord record;
};

// Runs a whole trial. Fails if physics refuses the body, or if it is asked to stop.
Result<RecordedTrial> record_trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
                                   const TrialWorld& world, const TrialWatch& watch = {},
                                   std::size_t most_bytes = kMostMotion);

// The trial computed once more, a tick at a time: every frame of a motion that is too long to be
// kept in memory.
class ReplayedMotion {
public:
    // Fails as record_trial() does.
    static Result<ReplayedMotion> start(std::shared_ptr<const Phenotype> phenotype,
                                        const Kinds& kinds, const TrialWorld& world);
    // As RecordedMotion::at() of a motion with every frame. Times must not decrease.
    MotionFrame at(double time);

private:
    explicit ReplayedMotion(std::unique_ptr<Trial> trial) : trial_(std::move(trial)) {}
    bool advance();

    std::unique_ptr<Trial> trial_;
    MotionFrame before_;
    MotionFrame after_;
    std::size_t tick_ = 0;  // of `before`
    bool ended_ = false;    // there is no further frame: `after` is the last one
};

}  // namespace cambrian
