#include "evolution/individual/behavior.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kRestingHeight = 0.005;  // m; height of a resting contact, which is slightly soft

double contact_share(const TrialRecord& record) {
    const auto touching = std::count_if(
        record.samples.begin(), record.samples.end(),
        [](const MotionSample& sample) { return sample.bounds.low.y() < kRestingHeight; });
    return static_cast<double>(touching) / static_cast<double>(record.samples.size());
}

double stir_between(const MotionSample& a, const MotionSample& b) {
    return std::max({(a.center_of_mass - b.center_of_mass).norm(),
                     (a.bounds.low - b.bounds.low).cwiseAbs().maxCoeff(),
                     (a.bounds.high - b.bounds.high).cwiseAbs().maxCoeff()});
}

double greatest_stir(const std::vector<MotionSample>& samples) {
    double greatest = 0.0;
    for (const MotionSample& sample : samples)
        greatest = std::max(greatest, stir_between(samples.front(), sample));
    return greatest;
}

}  // namespace

Behavior behavior_of(const Phenotype& phenotype, const TrialRecord& record) {
    Behavior behavior;
    behavior.movable_joints = static_cast<int>(
        std::count_if(phenotype.effectors.begin(), phenotype.effectors.end(),
                      [](const JointDegree& effector) { return effector.degree == 0; }));
    behavior.joint_frequency = record.reversal_rate;
    behavior.mean_joint_frequency = record.mean_reversal_rate;
    if (record.samples.empty()) return behavior;
    const Bounds& settled = record.samples.front().bounds;
    behavior.settled_height = settled.high.y() - settled.low.y();
    behavior.contact_share = contact_share(record);
    behavior.travel =
        (record.samples.back().center_of_mass - record.samples.front().center_of_mass).norm();
    behavior.stir = greatest_stir(record.samples);
    return behavior;
}

}  // namespace cambrian
