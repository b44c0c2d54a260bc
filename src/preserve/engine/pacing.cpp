#include "preserve/engine/pacing.h"

#include "simulator/trial.h"

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace cambrian {
namespace {

constexpr double kMostDelay = 0.25;         // s that are made up for
constexpr double kMeasuringInterval = 0.5;  // s

}  // namespace

void Pacing::set(double factor) {
    factor_ = factor;
    begin();
}

void Pacing::begin() {
    begun_.restart();
    ticks_ = 0;
    measured_.restart();
    measured_ticks_ = 0;
}

double Pacing::due() const {
    if (factor_ <= 0.0) return 0.0;
    return static_cast<double>(ticks_ + 1) * kBrainTick / factor_ - begun_.seconds();
}

bool Pacing::wait(const std::stop_token& stop) const {
    const double seconds = due();
    if (seconds > 0.0) {
        std::mutex mutex;
        std::condition_variable_any never;
        std::unique_lock lock(mutex);
        never.wait_for(lock, stop, std::chrono::duration<double>(seconds), [] { return false; });
    }
    return !stop.stop_requested();
}

void Pacing::count() {
    ++ticks_;
    ++measured_ticks_;
    if (due() < -kMostDelay) {
        begun_.restart();
        ticks_ = 0;
    }
    const double seconds = measured_.seconds();
    if (seconds < kMeasuringInterval) return;
    reached_ = static_cast<double>(measured_ticks_) * kBrainTick / seconds;
    measured_.restart();
    measured_ticks_ = 0;
}

}  // namespace cambrian
