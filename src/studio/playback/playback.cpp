#include "studio/playback/playback.h"

#include "core/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kLongestGap = 0.1;      // s; after a longer pause of the window, play on from here
constexpr std::uint64_t kTicksADot = 4;  // of the trail
constexpr std::size_t kTrailLength = 90;  // dots

}  // namespace

Status Playback::show(Exhibit exhibit) {
    auto phenotype = std::make_shared<const Phenotype>(
        express(*exhibit.genome, *kinds_, exhibit.expression, exhibit.world.scene));
    auto replay = Replay::start(phenotype, *kinds_, exhibit.world);
    if (!replay) return replay.error();
    replay_.reset();
    exhibit_ = std::move(exhibit);
    phenotype_ = std::move(phenotype);
    begin(std::move(*replay));
    return {};
}

void Playback::restart() {
    if (empty()) return;
    TrialWorld world = exhibit_.world;
    world.environment = environment();
    auto replay = Replay::start(phenotype_, *kinds_, world);
    if (replay) begin(std::move(*replay));
}

void Playback::begin(std::unique_ptr<Replay> replay) {
    replay_ = std::move(replay);
    owed_ = 0.0;
    sought_.reset();
    hold_.reset();
    signals_.clear();
    energy_.clear();
    dots_.clear();
    show_present();
}

double Playback::share() const {
    return playing_ ? std::clamp(owed_ / kBrainTick, 0.0, 1.0) : 1.0;
}

void Playback::set_environment(const Environment& environment) {
    if (!empty() && !(this->environment() == environment)) replay_->set_environment(environment);
}

void Playback::step() {
    if (empty()) return;
    playing_ = false;
    if (seeking()) return seek(*sought_ + 1);
    tick();
    show_present();
}

void Playback::step_back() {
    playing_ = false;
    if (tick_shown() > 0) seek(tick_shown() - 1);
}

void Playback::seek(std::uint64_t tick) {
    if (empty()) return;
    sought_ = tick;
    owed_ = 0.0;
    hold_.reset();
    if (tick >= replay_->ticks()) return;
    replay_->go_back(tick);
    signals_.clear();
    dots_.resize(replay_->ticks() / kTicksADot);
}

void Playback::go_on_seeking(double budget) {
    const Stopwatch spent;
    while (replay_->ticks() < *sought_ && !diverged() && spent.seconds() < budget)
        tick();
    if (replay_->ticks() < *sought_ && !diverged()) return;
    sought_.reset();
    show_present();
}

std::uint64_t Playback::length() const {
    if (empty()) return 0;
    const auto test =
        static_cast<std::uint64_t>(std::lround(exhibit_.world.trial.duration / kBrainTick));
    return std::max(trial().settle_ticks() + test, tick_shown());
}

std::span<const Vec2> Playback::trail() const {
    const std::size_t count = std::min(kTrailLength, dots_.size());
    return std::span(dots_).last(count);
}

void Playback::advance(double elapsed, double budget) {
    if (empty()) return;
    if (seeking()) return go_on_seeking(budget);
    if (!playing_) return;
    const Stopwatch spent;
    owed_ += speed_ * std::min(elapsed, kLongestGap);
    while (owed_ >= kBrainTick && spent.seconds() < budget) {
        tick();
        owed_ -= kBrainTick;
    }
    owed_ = std::fmin(owed_, 2.0 * kBrainTick);
    motion_.show(share());
}

void Playback::tick() {
    if (diverged()) return;
    replay_->tick(hold());
    motion_.follow(trial().scene());
    keep_readings();
    if (replay_->ticks() % kTicksADot == 0)
        dots_.push_back(trial().scene().center_of_mass().head<2>());
}

void Playback::keep_readings() {
    signals_.add(trial().creature().brain(), phenotype_->network.outputs.size());
    if (!trial().settling() && !trial().finished())
        energy_.add(trial().time(), trial().scene().audit());
}

void Playback::force(std::size_t neuron, double value) {
    auto forced = replay_->forced();
    forced[neuron] = value;
    replay_->set_forced(forced);
}

void Playback::release_neuron(std::size_t neuron) {
    auto forced = replay_->forced();
    forced.erase(neuron);
    replay_->set_forced(forced);
}

void Playback::poke(std::size_t part, const Vec3& point_in_part, const Vec3& target) {
    hold_ = Hold{part, point_in_part, target};
}

}  // namespace cambrian
