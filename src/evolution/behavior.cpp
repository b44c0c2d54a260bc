#include "evolution/behavior.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kTouching = 0.005;  // m; resting contact is a little soft

double contact_share(const TrialRecord& record) {
    const auto touching =
        std::count_if(record.samples.begin(), record.samples.end(),
                      [](const MotionSample& sample) { return sample.bounds.low.y() < kTouching; });
    return static_cast<double>(touching) / static_cast<double>(record.samples.size());
}

}  // namespace

Behavior behavior_of(const Phenotype& phenotype, const TrialRecord& record) {
    Behavior behavior;
    behavior.movable_joints = static_cast<int>(phenotype.effector_parts.size());
    behavior.joint_frequency = record.reversal_rate;
    if (record.samples.empty()) return behavior;
    const Bounds& settled = record.samples.front().bounds;
    behavior.settled_height = settled.high.y() - settled.low.y();
    behavior.contact_share = contact_share(record);
    return behavior;
}

}  // namespace cambrian
