#pragma once

// Trial records computed by a formula, for tests of scoring.

#include "simulator/settings/trial_settings.h"
#include "simulator/trial_record.h"

#include <functional>

namespace cambrian::test {

// Returns the record of a box whose centre follows a path for `duration` seconds. It is sampled
// every 0.1 s and watched for jumps every tick.
inline TrialRecord moving_box(double duration, double length, double height,
                              const std::function<Vec3(double time)>& path) {
    TrialRecord record;
    record.duration = duration;
    record.body_length = length;
    record.mass = length * height;
    const int samples = static_cast<int>(duration * 10.0 + 0.5);
    for (int i = 0; i <= samples; ++i) {
        const double time = 0.1 * i;
        const Vec3 center = path(time);
        MotionSample sample{time, center, {}};
        sample.bounds.add(center + Vec3(0.5 * length, 0.5 * height, 0.0));
        sample.bounds.add(center - Vec3(0.5 * length, 0.5 * height, 0.0));
        record.samples.push_back(sample);
        Supports supports;
        for (std::size_t k = 0; k < kHeadings; ++k)
            supports[k] = headings()[k].dot(center) + 0.5 * length;
        record.supports.push_back(supports);
    }
    const int ticks = static_cast<int>(duration / kBrainTick + 0.5);
    for (int i = 0; i <= ticks; ++i) {
        const double center = path(i * kBrainTick).y();
        record.jumps.watch(center - 0.5 * height, center);
    }
    return record;
}

}  // namespace cambrian::test
