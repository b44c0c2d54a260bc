#include "studio/playback/replay.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::uint64_t kFirstSpacing = 30;  // ticks between two stored states at first
constexpr std::size_t kMostKept = 240;       // with more stored states, every second one is dropped
constexpr double kHoldStiffness = 60.0;      // N/m per kg of creature
constexpr double kHoldDamping = 6.0;         // N s/m per kg of creature

// Returns the first entry of a list ordered by tick that is not before `tick`.
template <class List>
auto from_tick(List& list, std::uint64_t tick) {
    return std::lower_bound(list.begin(), list.end(), tick,
                            [](const auto& each, std::uint64_t at) { return each.tick < at; });
}

}  // namespace

Result<std::unique_ptr<Replay>> Replay::start(std::shared_ptr<const Phenotype> phenotype,
                                              const Kinds& kinds, const TrialWorld& world) {
    auto trial = Trial::start(std::move(phenotype), kinds, world);
    if (!trial) return trial.error();
    return std::unique_ptr<Replay>(new Replay(std::move(*trial)));
}

Replay::Replay(std::unique_ptr<Trial> trial) : trial_(std::move(trial)), spacing_(kFirstSpacing) {
    changes_.push_back({0, trial_->world().environment});
    keep();
}

void Replay::keep() {
    kept_.push_back({ticks(), trial_->save()});
    if (kept_.size() <= kMostKept) return;
    spacing_ *= 2;
    std::erase_if(kept_, [this](const Kept& each) { return each.tick % spacing_ != 0; });
}

const Hold* Replay::known_hold() const {
    const auto found = from_tick(pulls_, ticks());
    return found != pulls_.end() && found->tick == ticks() ? &found->hold : nullptr;
}

void Replay::tick(const Hold* hold) {
    if (diverged()) return;
    const auto change = first_change_from(ticks());
    if (change != changes_.end() && change->tick == ticks()) apply(*change);
    if (ticks() < known_until_) {
        hold = known_hold();
    } else if (hold != nullptr) {
        pulls_.push_back({ticks(), *hold});
    }
    if (hold != nullptr) pull(*hold);
    trial_->tick();
    if (ticks() % spacing_ == 0 && ticks() > kept_.back().tick) keep();
}

// Applies the force of a damped spring between the mouse and the grabbed point.
void Replay::pull(const Hold& hold) {
    PhysicsScene& scene = trial_->scene();
    const Pose pose = scene.part_pose(hold.part);
    const Twist twist = scene.part_twist(hold.part);
    const Vec3 arm = pose.orientation * hold.point_in_part;
    const Vec3 velocity = twist.linear + twist.angular.cross(arm);
    const Vec3 stretch = hold.target - (pose.position + arm);
    const Vec3 force = scene.mass() * (kHoldStiffness * stretch - kHoldDamping * velocity);
    scene.pull(hold.part, hold.point_in_part, force);
}

void Replay::apply(const Change& change) {
    trial_->set_environment(change.environment);
    Brain& brain = trial_->creature().brain();
    brain.release_all();
    for (const auto& [neuron, value] : change.forced)
        brain.force(neuron, value);
}

void Replay::go_back(std::uint64_t tick) {
    const Change present = changes_.back();
    const auto later = std::find_if(kept_.begin(), kept_.end(),
                                    [tick](const Kept& each) { return each.tick > tick; });
    kept_.erase(later, kept_.end());
    trial_->set_environment(change_before(kept_.back().tick).environment);
    trial_->restore(kept_.back().state);
    pulls_.erase(from_tick(pulls_, tick), pulls_.end());
    known_until_ = tick;
    change_from_now(present);
}

const Replay::Change& Replay::change_before(std::uint64_t tick) const {
    return *std::prev(first_change_from(tick));
}

std::vector<Replay::Change>::const_iterator Replay::first_change_from(std::uint64_t tick) const {
    return std::find_if(std::next(changes_.begin()), changes_.end(),
                        [tick](const Change& each) { return each.tick >= tick; });
}

void Replay::change_from_now(Change change) {
    change.tick = std::max(ticks(), known_until_);
    changes_.erase(first_change_from(change.tick), changes_.end());
    const Change& before = changes_.back();
    if (before.environment == change.environment && before.forced == change.forced) return;
    changes_.push_back(std::move(change));
}

void Replay::set_environment(const Environment& environment) {
    Change change = changes_.back();
    change.environment = environment;
    change_from_now(std::move(change));
}

void Replay::set_forced(const std::map<std::size_t, double>& forced) {
    Change change = changes_.back();
    change.forced = forced;
    change_from_now(std::move(change));
}

bool Replay::disturbed() const {
    return !pulls_.empty() || std::any_of(changes_.begin(), changes_.end(),
                                          [](const Change& each) { return !each.forced.empty(); });
}

}  // namespace cambrian
