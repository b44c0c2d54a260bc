#pragma once

// The motion of a trial as frames, which can be drawn in any order.

#include "core/result.h"
#include "pictures/motion/scuffs.h"
#include "simulator/trial.h"
#include "simulator/trial_watch.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace cambrian {

// The other bodies of a contest.
struct BoutFrame {
    Pose cube;
    std::vector<Pose> opponent;     // of each part; empty without an opponent
    std::vector<double> stretches;  // the same
};

struct MotionFrame {
    std::vector<Pose> poses;        // of each part
    std::vector<double> stretches;  // of each part
    Vec3 center_of_mass = Vec3::Zero();
    std::vector<FaceSet> touched;  // faces of each part that touch something
    std::optional<Vec3> light;     // m; place of the light, if there is one
    std::optional<BoutFrame> bout = {};
};

// Returns the present moment of a trial.
MotionFrame motion_frame(const Trial& trial);

// Adds the scuffs of a tick of the test between two frames.
void add_scuffs(std::vector<Scuff>& scuffs, const BodyPlan& plan, std::uint64_t tick,
                const MotionFrame& before, const MotionFrame& after, bool walks);

// One creature's trial from the end of settling. Every tick of 1/60 s is a frame; if that takes too
// much memory, every second tick, every fourth, and so on.
struct RecordedMotion {
    std::shared_ptr<const Phenotype> phenotype;      // null until expressed
    std::shared_ptr<const Phenotype> opponent = {};  // of a contest, if there is one
    std::vector<MotionFrame> frames;
    std::size_t stride = 1;             // ticks between two frames
    std::size_t ticks = 0;              // ticks after the first frame; used if stride is over 1
    std::vector<Vec2> centers;          // of mass, at every fourth tick; used if stride is over 1
    std::vector<Scuff> scuffs;          // of all ticks
    std::optional<FixedBox> wall = {};  // on one side, if there is one
    bool complete = false;

    bool empty() const { return frames.empty(); }
    double length() const;  // s
    // Returns the motion at a time. With stride 1 it interpolates between two frames, otherwise it
    // takes the last frame before. From the end on it is the last frame. The motion must not be
    // empty.
    MotionFrame at(double time) const;
    // Returns the centre of mass up to a time, oldest first, fifteen positions per second, at most
    // `most`.
    std::vector<Vec2> trail(double time, std::size_t most) const;
};

// Limit for the frames of one motion.
inline constexpr std::size_t kMostMotion = 48'000'000;  // bytes

struct RecordedTrial {
    RecordedMotion motion;  // up to the end of the test phase; has at least its start
    TrialRecord record;
    Environment environment;
};

// Runs a trial to its end. Fails if physics rejects the body or if a stop is requested.
Result<RecordedTrial> record_trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
                                   const TrialWorld& world, const TrialWatch& watch = {},
                                   std::size_t most_bytes = kMostMotion);

// Computes a trial once more, tick by tick. It gives every frame of a motion that is too long to be
// kept in memory.
class ReplayedMotion {
public:
    // Fails under the same conditions as record_trial().
    static Result<ReplayedMotion> start(std::shared_ptr<const Phenotype> phenotype,
                                        const Kinds& kinds, const TrialWorld& world);
    // Like RecordedMotion::at() for a motion with every frame. Times must not decrease.
    MotionFrame at(double time);

private:
    explicit ReplayedMotion(std::unique_ptr<Trial> trial) : trial_(std::move(trial)) {}
    bool advance();

    std::unique_ptr<Trial> trial_;
    MotionFrame before_;
    MotionFrame after_;
    std::size_t tick_ = 0;  // tick of `before`
    bool ended_ = false;    // `after` is the last frame
};

}  // namespace cambrian
