#include "pictures/recorded_motion.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kTicksADot = 4;  // of the trail

}  // namespace

MotionFrame motion_frame(const BodyView& body) {
    MotionFrame frame;
    frame.poses.resize(body.part_count());
    for (std::size_t part = 0; part < frame.poses.size(); ++part)
        frame.poses[part] = body.part_pose(part);
    frame.center_of_mass = body.center_of_mass();
    frame.touched = touched_faces(body);
    return frame;
}

double RecordedMotion::length() const {
    return frames.empty() ? 0.0 : static_cast<double>(frames.size() - 1) * kBrainTick;
}

MotionFrame RecordedMotion::at(double time) const {
    const double ticks = std::max(0.0, time / kBrainTick);
    const auto before = static_cast<std::size_t>(ticks);
    if (before + 1 >= frames.size()) return frames.back();
    const MotionFrame& from = frames[before];
    const MotionFrame& to = frames[before + 1];
    const double share = ticks - static_cast<double>(before);
    MotionFrame between = from;
    for (std::size_t i = 0; i < between.poses.size(); ++i) {
        between.poses[i].position += share * (to.poses[i].position - from.poses[i].position);
        between.poses[i].orientation =
            from.poses[i].orientation.slerp(share, to.poses[i].orientation);
    }
    between.center_of_mass += share * (to.center_of_mass - from.center_of_mass);
    return between;
}

std::vector<Vec2> RecordedMotion::trail(double time, std::size_t most) const {
    if (frames.empty()) return {};
    const auto now =
        std::min(static_cast<std::size_t>(std::max(0.0, time / kBrainTick)), frames.size() - 1);
    std::vector<Vec2> dots;
    for (std::size_t dot = std::min(now / kTicksADot, most); dot > 0; --dot) {
        const std::size_t tick = (now / kTicksADot - dot + 1) * kTicksADot;
        dots.push_back(frames[tick].center_of_mass.head<2>());
    }
    return dots;
}

Result<RecordedTrial> record_trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
                                   const TrialWorld& world) {
    auto trial = Trial::start(phenotype, kinds, world);
    if (!trial) return trial.error();
    MotionFrame start = motion_frame((*trial)->scene());
    while ((*trial)->settling() && (*trial)->tick())
        start = motion_frame((*trial)->scene());
    RecordedTrial recorded;
    recorded.motion.phenotype = std::move(phenotype);
    recorded.motion.complete = true;
    std::vector<MotionFrame>& frames = recorded.motion.frames;
    frames.push_back(std::move(start));
    while (!(*trial)->finished()) {
        (*trial)->tick();
        if ((*trial)->scene().status() != SceneStatus::kRunning) break;
        frames.push_back(motion_frame((*trial)->scene()));
    }
    recorded.record = (*trial)->take_record();
    return recorded;
}

}  // namespace cambrian
