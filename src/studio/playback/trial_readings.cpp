#include "studio/playback/trial_readings.h"

#include "simulator/trial.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::uint64_t kDotTicks = 4;    // ticks between two points of the trail
constexpr std::size_t kTraceLength = 90;  // points of the trail

constexpr std::size_t kMostScuffs = 50'000;

// Returns the number of ticks since the start of the test.
std::uint64_t test_tick(const Trial& trial) {
    return trial.ticks() - trial.settle_ticks();
}

}  // namespace

void TrialReadings::begin(const Trial& trial) {
    signals_.clear();
    energy_.clear();
    dots_.clear();
    dots_in_space_.clear();
    scuffs_.clear();
    remember_body(trial);
    if (!trial.settling()) posture_ = poses_;
}

void TrialReadings::remember_body(const Trial& trial) {
    const BodyView& body = trial.scene();
    poses_.resize(body.part_count());
    stretches_.resize(body.part_count());
    for (std::size_t part = 0; part < poses_.size(); ++part) {
        poses_[part] = body.part_pose(part);
        stretches_[part] = body.stretch(part);
    }
}

void TrialReadings::add(const Trial& trial, std::size_t outputs) {
    signals_.add(trial.creature().brain(), outputs);
    if (!trial.settling() && !trial.finished()) energy_.add(trial.time(), trial.scene().audit());
    const std::uint64_t tick = test_tick(trial);
    const std::vector<Pose> poses = std::move(poses_);
    const std::vector<double> stretches = std::move(stretches_);
    remember_body(trial);
    if (!trial.settling() && tick == 0) posture_ = poses_;
    if (trial.settling() || tick == 0) return;
    if (tick % kDotTicks == 0) {
        dots_in_space_.push_back(trial.scene().center_of_mass());
        dots_.emplace_back(dots_in_space_.back().head<2>());
    }
    if (scuffs_.size() > kMostScuffs)
        scuffs_.erase(scuffs_.begin(), scuffs_.begin() + kMostScuffs / 2);
    const std::vector<FaceSet> touched = touched_faces(trial.scene());
    add_scuffs(scuffs_, trial.phenotype().plan, tick, {poses, stretches, {}},
               {poses_, stretches_, touched}, trial.world().environment.has_ground);
}

void TrialReadings::go_back(const Trial& trial) {
    signals_.clear();
    dots_.resize(std::min<std::size_t>(dots_.size(), test_tick(trial) / kDotTicks));
    dots_in_space_.resize(dots_.size());
    while (!scuffs_.empty() && scuffs_.back().time > trial.time())
        scuffs_.pop_back();
    remember_body(trial);
}

std::span<const Vec2> TrialReadings::trail() const {
    return std::span(dots_).last(std::min(kTraceLength, dots_.size()));
}

std::span<const Vec3> TrialReadings::trail_in_space() const {
    return std::span(dots_in_space_).last(std::min(kTraceLength, dots_in_space_.size()));
}

}  // namespace cambrian
