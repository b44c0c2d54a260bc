#include "studio/playback/energy_trace.h"

namespace cambrian {
namespace {

constexpr double kSampleInterval = 0.1 - 1e-6;  // s between two samples

}  // namespace

EnergySample energy_sample(double time, const SceneAudit& audit) {
    EnergySample sample;
    sample.time = time;
    sample.muscles = audit.motor_work;
    sample.drag = -audit.drag_work;
    sample.contacts = -audit.contact_work - audit.limit_work - audit.impulse_work;
    sample.unexplained = -audit.energy_residual;
    sample.stored = sample.muscles - sample.drag - sample.contacts - sample.unexplained;
    return sample;
}

void EnergyTrace::add(double time, const SceneAudit& audit) {
    while (!samples_.empty() && samples_.back().time > time)
        samples_.pop_back();
    if (!samples_.empty() && time < samples_.back().time + kSampleInterval) return;
    samples_.push_back(energy_sample(time, audit));
}

}  // namespace cambrian
