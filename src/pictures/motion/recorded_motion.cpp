#include "pictures/motion/recorded_motion.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kTicksADot = 4;  // ticks between two points of the trail

void take_parts(const BodyView& body, std::vector<Pose>& poses, std::vector<double>& stretches) {
    poses.resize(body.part_count());
    stretches.resize(body.part_count());
    for (std::size_t part = 0; part < poses.size(); ++part) {
        poses[part] = body.part_pose(part);
        stretches[part] = body.stretch(part);
    }
}

}  // namespace

MotionFrame motion_frame(const Trial& trial) {
    const BodyView& body = trial.scene();
    MotionFrame frame;
    take_parts(body, frame.poses, frame.stretches);
    if (const Bout* bout = trial.bout()) {
        frame.bout.emplace();
        frame.bout->cube = bout->cube().part_pose(0);
        if (bout->opponent() != nullptr)
            take_parts(*bout->opponent(), frame.bout->opponent, frame.bout->stretches);
    }
    frame.center_of_mass = body.center_of_mass();
    frame.touched = touched_faces(body);
    const LightSource& light = trial.surroundings().source();
    if (light.is_on()) frame.light = light.place();
    return frame;
}

void add_scuffs(std::vector<Scuff>& scuffs, const BodyPlan& plan, std::uint64_t tick,
                const MotionFrame& before, const MotionFrame& after, bool walks) {
    add_scuffs(scuffs, plan, tick, {before.poses, before.stretches, before.touched},
               {after.poses, after.stretches, after.touched}, walks);
}

namespace {

Pose interpolated(const Pose& from, const Pose& to, double share) {
    return {from.position + share * (to.position - from.position),
            from.orientation.slerp(share, to.orientation)};
}

BoutFrame bout_between(const BoutFrame& from, const BoutFrame& to, double share) {
    BoutFrame between = from;
    between.cube = interpolated(from.cube, to.cube, share);
    for (std::size_t i = 0; i < between.opponent.size(); ++i)
        between.opponent[i] = interpolated(from.opponent[i], to.opponent[i], share);
    for (std::size_t i = 0; i < between.stretches.size(); ++i)
        between.stretches[i] += share * (to.stretches[i] - from.stretches[i]);
    return between;
}

MotionFrame between(const MotionFrame& from, const MotionFrame& to, double share) {
    MotionFrame between = from;
    for (std::size_t i = 0; i < between.poses.size(); ++i)
        between.poses[i] = interpolated(from.poses[i], to.poses[i], share);
    for (std::size_t i = 0; i < between.stretches.size(); ++i)
        between.stretches[i] += share * (to.stretches[i] - from.stretches[i]);
    if (from.bout && to.bout) between.bout = bout_between(*from.bout, *to.bout, share);
    between.center_of_mass += share * (to.center_of_mass - from.center_of_mass);
    return between;
}

// Runs the settling phase and returns the frame at its end.
MotionFrame settle(Trial& trial) {
    MotionFrame start = motion_frame(trial);
    while (trial.settling() && trial.tick())
        start = motion_frame(trial);
    return start;
}

std::size_t size_of(const MotionFrame& frame) {
    return sizeof(MotionFrame) + frame.poses.size() * (sizeof(Pose) + sizeof(double)) +
           frame.touched.size() * sizeof(FaceSet) +
           (frame.bout ? frame.bout->opponent.size() * (sizeof(Pose) + sizeof(double)) : 0);
}

// Records the frames of one trial; the longer the trial, the larger their interval.
class MotionRecorder {
public:
    MotionRecorder(RecordedMotion& motion, std::size_t most_bytes, bool walks)
        : motion_(motion), most_bytes_(most_bytes), walks_(walks) {}

    void add(MotionFrame frame) {
        if (tick_ > 0)
            add_scuffs(motion_.scuffs, motion_.phenotype->plan, tick_, before_, frame, walks_);
        before_ = frame;
        if (tick_ % kTicksADot == 0) motion_.centers.push_back(frame.center_of_mass.head<2>());
        if (tick_ % motion_.stride == 0) {
            if ((motion_.frames.size() + 1) * size_of(frame) > most_bytes_) thin_out();
            if (tick_ % motion_.stride == 0) motion_.frames.push_back(std::move(frame));
        }
        motion_.ticks = tick_++;
    }

private:
    void thin_out() {
        std::vector<MotionFrame>& frames = motion_.frames;
        const std::size_t kept = (frames.size() + 1) / 2;
        for (std::size_t i = 1; i < kept; ++i)
            frames[i] = std::move(frames[2 * i]);
        frames.resize(kept);
        motion_.stride *= 2;
    }

    RecordedMotion& motion_;
    MotionFrame before_;
    std::size_t most_bytes_;
    bool walks_;
    std::size_t tick_ = 0;
};

}  // namespace

double RecordedMotion::length() const {
    if (stride > 1) return static_cast<double>(ticks) * kBrainTick;
    return frames.empty() ? 0.0 : static_cast<double>(frames.size() - 1) * kBrainTick;
}

MotionFrame RecordedMotion::at(double time) const {
    const double moment = std::max(0.0, time / kBrainTick);
    const auto before = static_cast<std::size_t>(moment);
    if (stride > 1) return frames[std::min(before / stride, frames.size() - 1)];
    if (before + 1 >= frames.size()) return frames.back();
    return between(frames[before], frames[before + 1], moment - static_cast<double>(before));
}

std::vector<Vec2> RecordedMotion::trail(double time, std::size_t most) const {
    if (frames.empty()) return {};
    const std::size_t last = stride > 1 ? ticks : frames.size() - 1;
    const auto now = std::min(static_cast<std::size_t>(std::max(0.0, time / kBrainTick)), last);
    std::vector<Vec2> dots;
    for (std::size_t dot = std::min(now / kTicksADot, most); dot > 0; --dot) {
        const std::size_t place = now / kTicksADot - dot + 1;
        dots.push_back(stride > 1 ? centers[place]
                                  : Vec2(frames[place * kTicksADot].center_of_mass.head<2>()));
    }
    return dots;
}

Result<RecordedTrial> record_trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
                                   const TrialWorld& world, const TrialWatch& watch,
                                   std::size_t most_bytes) {
    auto started = Trial::start(phenotype, kinds, world);
    if (!started) return started.error();
    Trial& trial = **started;
    RecordedTrial recorded;
    recorded.motion.phenotype = std::move(phenotype);
    recorded.motion.complete = true;
    recorded.environment = trial.world().environment;
    if (trial.bout() != nullptr) recorded.motion.opponent = trial.bout()->opponent_body();
    MotionRecorder recorder(recorded.motion, most_bytes, world.environment.has_ground);
    recorder.add(settle(trial));
    if (trial.wall() != nullptr) recorded.motion.wall = *trial.wall();
    while (!trial.finished()) {
        if (watch.stop.stop_requested()) return Error{"interrupted; nothing was written"};
        trial.tick();
        if (trial.scene().status() != SceneStatus::kRunning) break;
        recorder.add(motion_frame(trial));
        watch.note(trial.time());
    }
    recorded.record = trial.take_record();
    return recorded;
}

Result<ReplayedMotion> ReplayedMotion::start(std::shared_ptr<const Phenotype> phenotype,
                                             const Kinds& kinds, const TrialWorld& world) {
    auto trial = Trial::start(std::move(phenotype), kinds, world);
    if (!trial) return trial.error();
    ReplayedMotion motion(std::move(*trial));
    motion.after_ = settle(*motion.trial_);
    motion.before_ = motion.after_;
    motion.ended_ = !motion.advance();
    return motion;
}

// Advances to the next frame; returns false after the last one.
bool ReplayedMotion::advance() {
    if (trial_->finished()) return false;
    trial_->tick();
    if (trial_->scene().status() != SceneStatus::kRunning) return false;
    before_ = std::exchange(after_, motion_frame(*trial_));
    return true;
}

MotionFrame ReplayedMotion::at(double time) {
    const double moment = std::max(0.0, time / kBrainTick);
    const auto tick = static_cast<std::size_t>(moment);
    for (; tick_ < tick && !ended_; ++tick_)
        ended_ = !advance();
    return ended_ ? after_ : between(before_, after_, moment - static_cast<double>(tick));
}

}  // namespace cambrian
