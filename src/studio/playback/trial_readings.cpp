#include "studio/playback/trial_readings.h"

#include "simulator/trial.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr std::uint64_t kTicksADot = 4;   // ticks between two points of the trail
constexpr std::size_t kTraceLength = 90;  // points of the trail

}  // namespace

void TrialReadings::clear() {
    signals_.clear();
    energy_.clear();
    dots_.clear();
}

void TrialReadings::add(const Trial& trial, std::size_t outputs) {
    signals_.add(trial.creature().brain(), outputs);
    if (!trial.settling() && !trial.finished()) energy_.add(trial.time(), trial.scene().audit());
    if (trial.ticks() % kTicksADot == 0) dots_.push_back(trial.scene().center_of_mass().head<2>());
}

void TrialReadings::go_back(std::uint64_t tick) {
    signals_.clear();
    dots_.resize(tick / kTicksADot);
}

std::span<const Vec2> TrialReadings::trail() const {
    return std::span(dots_).last(std::min(kTraceLength, dots_.size()));
}

}  // namespace cambrian
