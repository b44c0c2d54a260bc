#include "studio/playback.h"

#include "core/stopwatch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kLongestGap = 0.1;      // s; after a longer pause of the window, play on from here
constexpr std::uint64_t kTicksADot = 4;  // of the trail
constexpr std::size_t kTrailLength = 90;  // dots
constexpr double kPokeStiffness = 60.0;   // N/m a kg of creature
constexpr double kPokeDamping = 6.0;      // N s/m a kg

}  // namespace

Status Playback::show(Exhibit exhibit) {
    auto phenotype = std::make_shared<const Phenotype>(
        express(*exhibit.genome, *kinds_, exhibit.expression, exhibit.world.scene));
    auto trial = Trial::start(phenotype, *kinds_, exhibit.world);
    if (!trial) return trial.error();
    trial_.reset();
    exhibit_ = std::move(exhibit);
    environment_ = exhibit_.world.environment;
    phenotype_ = std::move(phenotype);
    begin(std::move(*trial));
    return {};
}

void Playback::restart() {
    if (empty()) return;
    TrialWorld world = exhibit_.world;
    world.environment = environment_;
    auto trial = Trial::start(phenotype_, *kinds_, world);
    if (trial) begin(std::move(*trial));
}

void Playback::begin(std::unique_ptr<Trial> trial) {
    trial_ = std::move(trial);
    owed_ = 0.0;
    disturbed_ = false;
    poked_part_ = -1;
    forced_.clear();
    signals_.clear();
    energy_.clear();
    trail_.clear();
    capture(current_);
    current_center_ = trial_->scene().center_of_mass();
    previous_ = current_;
    previous_center_ = current_center_;
    interpolate();
}

void Playback::set_environment(const Environment& environment) {
    if (empty() || environment_ == environment) return;
    environment_ = environment;
    trial_->scene().set_environment(environment);
}

bool Playback::diverged() const {
    return !empty() && trial_->scene().status() != SceneStatus::kRunning;
}

void Playback::step() {
    if (empty()) return;
    playing_ = false;
    tick();
    previous_ = current_;
    previous_center_ = current_center_;
    interpolate();
}

void Playback::advance(double elapsed, double budget) {
    if (empty() || !playing_) return;
    const Stopwatch spent;
    owed_ += speed_ * std::min(elapsed, kLongestGap);
    while (owed_ >= kBrainTick && spent.seconds() < budget) {
        tick();
        owed_ -= kBrainTick;
    }
    owed_ = std::fmin(owed_, 2.0 * kBrainTick);
    interpolate();
}

void Playback::tick() {
    if (diverged()) return;
    std::swap(previous_, current_);
    previous_center_ = current_center_;
    pull();
    trial_->tick();
    keep_readings();
    capture(current_);
    current_center_ = trial_->scene().center_of_mass();
    if (trial_->ticks() % kTicksADot != 0) return;
    if (trail_.size() == kTrailLength) trail_.erase(trail_.begin());
    trail_.push_back(current_center_.head<2>());
}

void Playback::keep_readings() {
    const Trial& trial = *trial_;
    signals_.add(trial.creature().brain(), phenotype_->network.outputs.size());
    if (!trial.settling() && !trial.finished()) energy_.add(trial.time(), trial.scene().audit());
}

void Playback::force(std::size_t neuron, double value) {
    trial_->creature().brain().force(neuron, value);
    forced_[neuron] = value;
    disturbed_ = true;
}

void Playback::release_neuron(std::size_t neuron) {
    trial_->creature().brain().release(neuron);
    forced_.erase(neuron);
}

void Playback::poke(std::size_t part, const Vec3& point_in_part, const Vec3& target) {
    poked_part_ = static_cast<int>(part);
    poke_point_ = point_in_part;
    poke_target_ = target;
    disturbed_ = true;
}

// A damped spring between the mouse and the point taken hold of.
void Playback::pull() {
    if (poked_part_ < 0) return;
    const auto part = static_cast<std::size_t>(poked_part_);
    PhysicsScene& scene = trial_->scene();
    const Pose pose = scene.part_pose(part);
    const Twist twist = scene.part_twist(part);
    const Vec3 arm = pose.orientation * poke_point_;
    const Vec3 velocity = twist.linear + twist.angular.cross(arm);
    const Vec3 stretch = poke_target_ - (pose.position + arm);
    const double mass = scene.mass();
    scene.pull(part, poke_point_, mass * (kPokeStiffness * stretch - kPokeDamping * velocity));
}

void Playback::capture(std::vector<Pose>& poses) const {
    const PhysicsScene& scene = trial_->scene();
    poses.resize(scene.part_count());
    for (std::size_t part = 0; part < poses.size(); ++part)
        poses[part] = scene.part_pose(part);
}

void Playback::interpolate() {
    const double share = std::clamp(owed_ / kBrainTick, 0.0, 1.0);
    shown_.resize(current_.size());
    for (std::size_t part = 0; part < current_.size(); ++part) {
        const Pose& from = previous_[part];
        const Pose& to = current_[part];
        shown_[part].position = from.position + share * (to.position - from.position);
        shown_[part].orientation = from.orientation.slerp(share, to.orientation);
    }
    shown_center_ = previous_center_ + share * (current_center_ - previous_center_);
}

}  // namespace cambrian
