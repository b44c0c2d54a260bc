#include "studio/playback/playback.h"

#include "core/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {

Status Playback::show(Exhibit exhibit) {
    if (Status status = creature_.show(std::move(exhibit)); !status) return status;
    owed_ = 0.0;
    sought_.reset();
    return {};
}

void Playback::restart() {
    if (empty()) return;
    creature_.restart();
    owed_ = 0.0;
    sought_.reset();
}

Status Playback::deprive(std::vector<Lesion> lesions) {
    if (empty()) return {};
    if (Status status = creature_.deprive(std::move(lesions)); !status) return status;
    owed_ = 0.0;
    sought_.reset();
    return {};
}

void Playback::show_trial(int trial) {
    if (empty()) return;
    creature_.show_trial(trial);
    owed_ = 0.0;
    sought_.reset();
}

double Playback::share() const {
    return pace_.playing ? std::clamp(owed_ / kBrainTick, 0.0, 1.0) : 1.0;
}

void Playback::step() {
    if (empty()) return;
    pace_.playing = false;
    if (seeking()) return seek(*sought_ + 1);
    creature_.tick();
    creature_.show_present();
}

void Playback::step_back() {
    pace_.playing = false;
    if (tick_shown() > 0) seek(tick_shown() - 1);
}

void Playback::seek(std::uint64_t tick) {
    if (empty()) return;
    sought_ = tick;
    owed_ = 0.0;
    creature_.pull(std::nullopt);
    if (tick < trial().ticks()) creature_.go_back(tick);
}

void Playback::go_on_seeking(double budget) {
    const Replay& replay = creature_.replay();
    const Stopwatch spent;
    while (replay.ticks() < *sought_ && !replay.diverged() && spent.seconds() < budget)
        creature_.tick();
    if (replay.ticks() < *sought_ && !replay.diverged()) return;
    sought_.reset();
    creature_.show_present();
}

std::uint64_t Playback::length() const {
    if (empty()) return 0;
    const auto test = static_cast<std::uint64_t>(
        std::lround(exhibit().settings().world.trial.duration / kBrainTick));
    return std::max(trial().settle_ticks() + test, tick_shown());
}

void Playback::advance(double elapsed, double budget) {
    if (empty()) return;
    if (seeking()) return go_on_seeking(budget);
    if (!pace_.playing) return;
    const Stopwatch spent;
    owed_ += pace_.speed * std::min(elapsed, kLongestGap);
    while (owed_ >= kBrainTick && spent.seconds() < budget) {
        creature_.tick();
        owed_ -= kBrainTick;
    }
    owed_ = std::fmin(owed_, 2.0 * kBrainTick);
    creature_.show_moment(share());
}

}  // namespace cambrian
