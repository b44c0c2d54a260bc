#pragma once

#include "simulator/trial_record.h"

#include <array>

namespace cambrian {

// Returns the sample nearest to a share (0 to 1) of the test phase; the record must have samples.
const MotionSample& sample_at(const TrialRecord& record, double share);

// Four windows, a fifth of the test phase each; the first fifth is in none.
inline constexpr std::array<double, 4> kWindowStarts = {0.2, 0.4, 0.6, 0.8};  // shares
inline constexpr double kWindow = 0.2;

// Mean speeds (m/s) of the centre of mass along a direction, one a window.
using WindowSpeeds = std::array<double, kWindowStarts.size()>;
WindowSpeeds window_speeds(const TrialRecord& record, const Vec3& direction);

// (v1 + v2 + 2 v3 + 3 v4) / 14 + min(v) / 2
double steady_speed(const WindowSpeeds& speeds);

}  // namespace cambrian
