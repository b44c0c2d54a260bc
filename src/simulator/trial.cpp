#include "simulator/trial.h"

#include "core/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kStartClearance = 0.02;  // m, lowest corner above ground
constexpr double kCalmEnergy = 0.001;     // J a part; below it a creature has settled...
constexpr int kCalmTicks = 24;            // ...if for 0.4 s
constexpr int kDeepTicks = 12;            // 0.2 s
// Trials that took fewer are finished rather than run again later: some tenths of a second.
constexpr std::uint64_t kLongTrial = 100000;  // evaluations

int ticks_in(double seconds) {
    return static_cast<int>(std::lround(seconds / kBrainTick));
}

}  // namespace

Result<std::unique_ptr<Trial>> Trial::start(std::shared_ptr<const Phenotype> phenotype,
                                            const Kinds& kinds, const TrialWorld& world) {
    auto scene = kinds.scene.make(phenotype->plan, world.environment, world.scene);
    if (!scene) return scene.error();
    return std::unique_ptr<Trial>(new Trial(std::move(phenotype), kinds, world, std::move(*scene)));
}

Trial::Trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
             const TrialWorld& world, std::unique_ptr<PhysicsScene> scene)
    : phenotype_(std::move(phenotype)),
      world_(world),
      scene_(std::move(scene)),
      creature_(*phenotype_, kinds, world_.scene),
      rest_(*phenotype_, kinds) {
    record_.duration = world_.trial.duration;
    record_.body_length = phenotype_->rest_length();
    record_.mass = scene_->mass();
    record_.samples.reserve(
        static_cast<std::size_t>(ticks_in(world_.trial.duration) / kTicksPerSample) + 2);
    place_at_start();
    scene_->add_to_digest(digest_);
    settling_ = world_.environment.has_ground && world_.trial.settle_limit > 0.0;
    if (!settling_) {
        begin_test();
    } else if (world_.trial.limp_settle) {
        scene_->set_limp(true);
    }
}

void Trial::place_at_start() {
    const Vec3 center = scene_->center_of_mass();
    const double lift =
        world_.environment.has_ground ? kStartClearance - scene_->bounds().low.y() : -center.y();
    scene_->translate(Vec3(-center.x(), lift, 0.0));
}

bool Trial::tick() {
    if (scene_->status() != SceneStatus::kRunning) return false;
    ++total_ticks_;
    if (settling_) {
        settle_tick();
    } else {
        test_tick();
    }
    return !finished_;
}

void Trial::settle_tick() {
    creature_.hold_rest(*scene_);
    if (const SceneStatus status = scene_->advance(kBrainTick); status != SceneStatus::kRunning) {
        fail_with(status);
        return;
    }
    const double calm = kCalmEnergy * static_cast<double>(phenotype_->parts.size());
    calm_ticks_ = scene_->kinetic_energy() < calm ? calm_ticks_ + 1 : 0;
    record_.settle_time = static_cast<double>(total_ticks_) * kBrainTick;
    const bool out_of_time = static_cast<int>(total_ticks_) >= ticks_in(world_.trial.settle_limit);
    if (calm_ticks_ >= kCalmTicks || out_of_time) begin_test();
}

void Trial::begin_test() {
    if (settling_ && world_.trial.limp_settle) scene_->set_limp(false);
    settling_ = false;
    scene_->restart_audit();
    for (const std::uint16_t part : phenotype_->effector_parts) {
        reversals_.emplace_back(scene_->joint_coordinate(part));
    }
    sample();
    if (ticks_in(world_.trial.duration) == 0) finish();
}

void Trial::test_tick() {
    creature_.act(*scene_, kBrainTick);
    const SceneStatus status = scene_->advance(kBrainTick);
    ++test_ticks_;
    if (finished_) return;
    if (status != SceneStatus::kRunning) {
        fail_with(status);
        return;
    }
    for (std::size_t i = 0; i < reversals_.size(); ++i) {
        reversals_[i].watch(scene_->joint_coordinate(phenotype_->effector_parts[i]));
    }
    check_guards();
    if (finished_) return;
    const bool last = static_cast<int>(test_ticks_) >= ticks_in(world_.trial.duration);
    if (last || test_ticks_ % kTicksPerSample == 0) sample();
    if (last) {
        finish();
    } else if (world_.trial.stop_at_rest && rest_.watch(*scene_, creature_.brain())) {
        stop_early(Outcome::kCompleted, "");
    }
}

void Trial::stop_early(Outcome outcome, std::string reason) {
    const auto all = static_cast<std::uint64_t>(ticks_in(world_.trial.duration));
    for (std::uint64_t tick = test_ticks_ + 1; tick <= all; ++tick) {
        if (tick != all && tick % kTicksPerSample != 0) continue;
        MotionSample repeated = record_.samples.back();
        repeated.time = static_cast<double>(tick) * kBrainTick;
        record_.samples.push_back(repeated);
    }
    record_.outcome = outcome;
    record_.reason = std::move(reason);
    finish();
}

void Trial::sample() {
    const Bounds bounds = scene_->bounds();
    const Vec3 sides = bounds.high - bounds.low;
    record_.body_length = std::max({record_.body_length, sides.x(), sides.y()});
    record_.samples.push_back({time(), scene_->center_of_mass(), bounds});
    scene_->add_to_digest(digest_);
}

void Trial::check_guards() {
    const SceneAudit& audit = scene_->audit();
    const TrialSettings& limits = world_.trial;
    if (audit.max_part_speed > limits.max_part_speed) {
        fail(Outcome::kCheated, "a part moved faster than the limit");
    } else if (audit.max_part_spin > limits.max_part_spin) {
        fail(Outcome::kCheated, "a part spun faster than the limit");
    } else if (audit.max_penetration > limits.max_ground_depth) {
        const bool deep = scene_->bounds().low.y() < -limits.max_ground_depth;
        deep_ticks_ = world_.environment.has_ground && deep ? deep_ticks_ + 1 : 0;
        if (deep_ticks_ > kDeepTicks) fail(Outcome::kCheated, "a part sank into the ground");
    }
}

void Trial::fail_with(SceneStatus status) {
    const std::string when = settling_ ? " while settling" : "";
    if (status == SceneStatus::kOverBudget) {
        fail(Outcome::kOverBudget,
             "the motion is too stiff or too violent to compute" + when + ": it takes more than " +
                 short_text(world_.scene.max_evaluations) + " evaluations a second");
    } else {
        fail(Outcome::kDiverged, "the motion diverged" + when);
    }
}

Trial::State Trial::save() const {
    return {scene_->save(), creature_.save(), record_,     digest_,     reversals_, rest_,
            total_ticks_,   test_ticks_,      calm_ticks_, deep_ticks_, settling_,  finished_};
}

void Trial::restore(const State& state) {
    scene_->set_limp(state.settling && world_.trial.limp_settle);
    scene_->restore(*state.scene);
    creature_.restore(state.creature);
    record_ = state.record;
    digest_ = state.digest;
    reversals_ = state.reversals;
    rest_ = state.rest;
    total_ticks_ = state.total_ticks;
    test_ticks_ = state.test_ticks;
    calm_ticks_ = state.calm_ticks;
    deep_ticks_ = state.deep_ticks;
    settling_ = state.settling;
    finished_ = state.finished;
}

void Trial::heed(const std::stop_token& stop) {
    if (finished_ || scene_->audit().evaluations <= kLongTrial || !stop.stop_requested()) return;
    fail(Outcome::kInterrupted, "stopped before its end");
}

void Trial::fail(Outcome outcome, std::string reason) {
    record_.outcome = outcome;
    record_.reason = std::move(reason);
    settling_ = false;
    finish();
}

void Trial::finish() {
    finished_ = true;
    record_.audit = scene_->audit();
    record_.digest = digest_.value();
    int most = 0;
    int all = 0;
    for (const ReversalCounter& joint : reversals_) {
        most = std::max(most, joint.count());
        all += joint.count();
    }
    record_.computed_time = time();
    const bool failed = is_invalid(record_.outcome);
    const double lasted = failed ? time() : ticks_in(world_.trial.duration) * kBrainTick;
    if (lasted <= 0.0 || reversals_.empty()) return;
    record_.reversal_rate = 0.5 * most / lasted;
    record_.mean_reversal_rate = 0.5 * all / static_cast<double>(reversals_.size()) / lasted;
}

Result<TrialRecord> run_trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
                              const TrialWorld& world, const std::stop_token& stop) {
    auto trial = Trial::start(std::move(phenotype), kinds, world);
    if (!trial) return trial.error();
    while ((*trial)->tick())
        (*trial)->heed(stop);
    return (*trial)->take_record();
}

}  // namespace cambrian
