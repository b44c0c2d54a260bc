#include "studio/replay.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr std::uint64_t kFirstSpacing = 30;  // ticks
constexpr std::size_t kMostKept = 240;       // beyond it every second moment is let go
constexpr double kHoldStiffness = 60.0;      // N/m a kg of creature
constexpr double kHoldDamping = 6.0;         // N s/m a kg

// The first entry of a list by tick that is not before a tick.
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
    if (change != changes_.end() && change->tick == ticks())
        trial_->scene().set_environment(change->environment);
    if (ticks() < known_until_) {
        hold = known_hold();
    } else if (hold != nullptr) {
        pulls_.push_back({ticks(), *hold});
    }
    if (hold != nullptr) pull(*hold);
    trial_->tick();
    if (ticks() % spacing_ == 0 && ticks() > kept_.back().tick) keep();
}

// A damped spring between the hand and the point taken hold of.
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

void Replay::go_back(std::uint64_t tick) {
    const Environment present = environment();
    const auto later = std::find_if(kept_.begin(), kept_.end(),
                                    [tick](const Kept& each) { return each.tick > tick; });
    kept_.erase(later, kept_.end());
    trial_->scene().set_environment(environment_before(kept_.back().tick));
    trial_->restore(kept_.back().state);
    pulls_.erase(from_tick(pulls_, tick), pulls_.end());
    known_until_ = tick;
    if (!(present == environment_before(tick))) set_environment(present);
}

const Environment& Replay::environment_before(std::uint64_t tick) const {
    return std::prev(first_change_from(tick))->environment;
}

std::vector<Replay::Change>::const_iterator Replay::first_change_from(std::uint64_t tick) const {
    return std::find_if(std::next(changes_.begin()), changes_.end(),
                        [tick](const Change& each) { return each.tick >= tick; });
}

void Replay::set_environment(const Environment& environment) {
    const std::uint64_t from = std::max(ticks(), known_until_);
    changes_.erase(first_change_from(from), changes_.end());
    changes_.push_back({from, environment});
}

}  // namespace cambrian
