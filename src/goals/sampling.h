#pragma once

#include "simulator/trial_record.h"

#include <array>

namespace cambrian {

// Returns the sample nearest to a share (0 to 1) of the test phase; the record must have samples.
const MotionSample& sample_at(const TrialRecord& record, double share);
std::size_t sample_index(const TrialRecord& record, double share);

// Starts of four windows, each a fifth of the test phase. The first fifth is ignored.
inline constexpr std::array<double, 4> kWindowStarts = {0.2, 0.4, 0.6, 0.8};  // shares
inline constexpr double kWindow = 0.2;

// Returns the mean speed (m/s) of the centre of mass along a direction in each window.
using WindowSpeeds = std::array<double, kWindowStarts.size()>;
WindowSpeeds window_speeds(const TrialRecord& record, const Vec3& direction);

// Returns (v1 + v2 + 2 v3 + 3 v4) / 14 + min(v) / 2 of the speeds v1 to v4.
double steady_speed(const WindowSpeeds& speeds);

}  // namespace cambrian
