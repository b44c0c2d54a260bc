#include "simulator/trial.h"

#include "core/random.h"
#include "core/text/number_text.h"
#include "math/angle.h"
#include "simulator/passive_sink.h"
#include "world/terrain.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr int kGroundPlaces = 4;          // to either side of one where the ground is measured
constexpr double kBetweenPlaces = 0.125;  // m
constexpr int kCalmTicks = 24;            // 0.4 s
constexpr int kDeepTicks = 12;            // 0.2 s
constexpr std::uint64_t kGround = 104;    // separates the draws of the ground from others
constexpr int kLengthTicks = 3;           // 0.05 s between two measurements of the body's length
// Trials with fewer evaluations take some tenths of a second and are finished rather than
// interrupted.
constexpr std::uint64_t kLongTrial = 100000;  // evaluations

int ticks_in(double seconds) {
    return static_cast<int>(std::lround(seconds / kBrainTick));
}

Vec3 up_of(const Environment& environment) {
    if (!(environment.gravity > 0.0)) return Vec3::UnitY();
    const SineCosine pull = sine_cosine_of_degrees(environment.gravity_direction);
    return {-pull.cosine, -pull.sine, 0.0};
}

// Returns the environment with the ground that chance gives to this trial.
Environment with_ground_of(const LightDraw& draw, Environment environment) {
    TerrainSettings& terrain = environment.terrain;
    if (terrain.same) return environment;
    terrain.seed =
        stream_seed({terrain.seed, draw.seed, static_cast<std::uint64_t>(draw.trial), kGround});
    terrain.same = true;
    return environment;
}

// Returns the environment of a world before it is tilted to the other side.
Environment tilted(const TrialWorld& world) {
    Environment environment = with_ground_of(world.light, world.environment);
    environment.gravity_direction += world.tilt;
    return environment;
}

// Returns the mean height of the ground around a place, in m.
double ground_around(const Terrain& ground, double x) {
    double sum = ground.height(x);
    for (int place = 1; place <= kGroundPlaces; ++place) {
        const double aside = kBetweenPlaces * place;
        sum += ground.height(x - aside) + ground.height(x + aside);
    }
    return sum / (2 * kGroundPlaces + 1);
}

Result<std::unique_ptr<Bout>> begin_bout(const Kinds& kinds, const TrialWorld& world,
                                         PhysicsScene& own) {
    std::shared_ptr<const Phenotype> opponent;
    if (const GenomePtr genome = world.opponents.of_trial(world.light.trial))
        opponent = std::make_shared<const Phenotype>(
            express(*genome, kinds, world.expression, world.scene, Side::kMirrored));
    const Environment environment = tilted(world);
    return Bout::start(std::move(opponent), kinds, {environment, world.scene, world.light}, own);
}

}  // namespace

TrialWorld with_drawn_ground(TrialWorld world) {
    world.environment = with_ground_of(world.light, world.environment);
    return world;
}

Result<std::unique_ptr<Trial>> Trial::start(std::shared_ptr<const Phenotype> phenotype,
                                            const Kinds& kinds, const TrialWorld& world) {
    auto scene = kinds.scene.make(phenotype->plan, tilted(world), world.scene);
    if (!scene) return scene.error();
    std::unique_ptr<Bout> bout;
    if (world.trial.has_cube) {
        auto begun = begin_bout(kinds, world, **scene);
        if (!begun) return begun.error();
        bout = std::move(*begun);
    }
    return std::unique_ptr<Trial>(
        new Trial(std::move(phenotype), kinds, world, {std::move(*scene), std::move(bout)}));
}

Trial::Trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
             const TrialWorld& world, Bodies bodies)
    : phenotype_(std::move(phenotype)),
      world_(with_drawn_ground(world)),
      test_length_(static_cast<std::uint64_t>(ticks_in(world.trial.duration))),
      scene_(std::move(bodies.scene)),
      bout_(std::move(bodies.bout)),
      surroundings_(tilted(world_), world_.light, senses_of(*phenotype_, kinds)),
      creature_(*phenotype_, kinds, world_.scene),
      length_(phenotype_->parts.size()),
      coordinates_(phenotype_->effectors.size()),
      progress_{.rest = RestWatch(phenotype_->network, kinds.functions)} {
    progress_.record.duration = world_.trial.duration;
    progress_.record.body_length = phenotype_->rest_length();
    progress_.record.mass = scene_->mass();
    progress_.record.has_ground = world_.environment.has_ground;
    progress_.record.dimensions = world_.environment.dimensions;
    progress_.record.up = up_of(world.environment);
    if (const auto ground = Terrain::make(world_.environment.terrain)) ground_ = *ground;
    if (ground_) progress_.record.level_ground = world_.environment.terrain.pad;
    progress_.record.passive_sink = passive_sink(world_.environment);
    progress_.record.samples.reserve(test_length_ / kTicksPerSample + 2);
    if (world_.environment.dimensions == 3)
        progress_.record.supports.reserve(test_length_ / kTicksPerSample + 2);
    impacts_.reserve(kMostImpacts);
    if (world_.environment.has_light) progress_.record.legs.reserve(leg_count());
    if (!bout_) place_at_start();
    add_to_digest();
    progress_.settling = world_.environment.has_ground && world_.trial.settle_limit > 0.0;
    if (!progress_.settling) {
        begin_test();
    } else if (world_.trial.settle_motors_off) {
        set_motors_off(true);
    }
}

void Trial::set_motors_off(bool off) {
    scene_->set_motors_off(off);
    if (bout_) bout_->set_motors_off(off);
}

SceneStatus Trial::settle() {
    return bout_ ? bout_->settle(*scene_, kBrainTick) : scene_->advance(kBrainTick);
}

SceneStatus Trial::advance() {
    return bout_ ? bout_->advance(*scene_, kBrainTick) : scene_->advance(kBrainTick);
}

void Trial::add_to_digest() {
    scene_->add_to_digest(progress_.digest);
    if (bout_) bout_->add_to_digest(progress_.digest);
}

void Trial::set_environment(const Environment& edited) {
    const Environment environment = with_ground_of(world_.light, edited);
    scene_->set_environment(environment);
    surroundings_.set_environment(environment);
    if (bout_) bout_->set_environment(environment);
}

void Trial::place_at_start() {
    const Environment& environment = world_.environment;
    // What is below the creature depends on where it stands.
    if (!environment.terrain.is_flat())
        scene_->translate(Vec3(-scene_->center_of_mass().x(), 0.0, 0.0));
    const Vec3 center = scene_->center_of_mass();
    const double lift =
        environment.has_ground ? kStartClearance - scene_->ground_gap() : -center.y();
    scene_->translate(Vec3(-center.x(), lift, -center.z()));
}

bool Trial::tick() {
    if (scene_->status() != SceneStatus::kRunning) return false;
    ++progress_.total_ticks;
    if (progress_.settling) {
        settle_tick();
    } else {
        test_tick();
    }
    return !progress_.finished;
}

void Trial::settle_tick() {
    creature_.hold_rest(*scene_);
    if (const SceneStatus status = settle(); status != SceneStatus::kRunning) {
        fail_with(status);
        return;
    }
    const double calm_limit = progress_.record.dimensions == 3
                                  ? calm_energy_in_space(scene_->mass())
                                  : calm_energy(phenotype_->parts.size());
    const bool calm = scene_->kinetic_energy() < calm_limit && (!bout_ || bout_->is_calm());
    progress_.calm_ticks = calm ? progress_.calm_ticks + 1 : 0;
    progress_.record.settle_time = static_cast<double>(progress_.total_ticks) * kBrainTick;
    const bool out_of_time =
        static_cast<int>(progress_.total_ticks) >= ticks_in(world_.trial.settle_limit);
    if (progress_.calm_ticks >= kCalmTicks || out_of_time) begin_test();
}

void Trial::begin_test() {
    if (progress_.settling && world_.trial.settle_motors_off) set_motors_off(false);
    progress_.settling = false;
    if (bout_) bout_->begin(*scene_);
    if (world_.environment.has_wall) {
        progress_.wall = draw_side_wall(world_.environment, world_.light, scene_->bounds());
        progress_.record.wall_side = progress_.wall->side;
        put_up_wall();
    }
    scene_->restart_audit();
    for (const JointDegree& effector : phenotype_->effectors) {
        progress_.reversals.emplace_back(scene_->joint_coordinate(effector));
    }
    watch_body();
    sample();
    if (test_length_ == 0) finish();
}

void Trial::put_up_wall() {
    surroundings_.set_wall(wall());
    scene_->set_fixed_boxes(progress_.wall ? std::span(wall(), 1) : std::span<const FixedBox>());
}

double Trial::distance_to_light() const {
    return (surroundings_.source().place() - scene_->center_of_mass()).norm();
}

std::size_t Trial::leg_count() const {
    const std::uint64_t leg = surroundings_.source().leg_ticks();
    return (test_length_ + leg - 1) / leg;
}

void Trial::tilt_back() {
    if (world_.tilt == 0.0 || progress_.test_ticks != test_length_ / 2) return;
    Environment other = world_.environment;
    other.gravity_direction -= world_.tilt;
    set_environment(other);
}

// Moves the light before the creature reads its sensors.
void Trial::move_light() {
    LightSource& source = surroundings_.source();
    if (!source.is_on()) return;
    const double length = progress_.record.body_length;
    source.move(progress_.test_ticks, scene_->center_of_mass(), length);
    if (!progress_.finished && progress_.test_ticks % source.leg_ticks() == 0)
        progress_.record.legs.begin(time(), source.place() - scene_->center_of_mass(), length);
}

// Returns whether nothing can move any more. A moving light, a smell or an opponent may wake a
// resting creature.
bool Trial::rests() {
    return world_.trial.stop_at_rest && !bout_ && !surroundings_.changes() &&
           progress_.rest.watch(*scene_, creature_.brain());
}

// Sounds and scents of the creature and its impacts can be sensed in the next tick.
void Trial::pass_on_emissions() {
    scene_->list_impacts(impacts_);
    surroundings_.take(creature_.emissions(), impacts_, progress_.test_ticks);
    if (bout_) bout_->pass_on_emissions(progress_.test_ticks);
}

void Trial::test_tick() {
    tilt_back();
    move_light();
    creature_.act(*scene_, surroundings_, kBrainTick);
    if (bout_) bout_->act(progress_.test_ticks);
    const SceneStatus status = advance();
    pass_on_emissions();
    ++progress_.test_ticks;
    if (progress_.finished) return;
    if (status != SceneStatus::kRunning) {
        fail_with(status);
        return;
    }
    watch_reversals();
    check_guards();
    if (progress_.finished) return;
    watch_body();
    if (surroundings_.source().is_on()) progress_.record.legs.watch(distance_to_light());
    const bool last = progress_.test_ticks >= test_length_;
    if (last || progress_.test_ticks % kTicksPerSample == 0) sample();
    if (last) {
        finish();
    } else if (rests()) {
        stop_early(Outcome::kCompleted, "");
    }
}

void Trial::stop_early(Outcome outcome, std::string reason) {
    for (std::uint64_t tick = progress_.test_ticks + 1; tick <= test_length_; ++tick) {
        if (tick != test_length_ && tick % kTicksPerSample != 0) continue;
        MotionSample repeated = progress_.record.samples.back();
        repeated.time = static_cast<double>(tick) * kBrainTick;
        progress_.record.samples.push_back(repeated);
        progress_.record.repeat_supports();
    }
    progress_.record.legs.rest(leg_count(), world_.trial.duration);
    progress_.record.outcome = outcome;
    progress_.record.reason = std::move(reason);
    finish();
}

void Trial::watch_reversals() {
    scene_->list_joint_coordinates(phenotype_->effectors, coordinates_);
    const double* coordinate = coordinates_.data();
    for (ReversalCounter& joint : progress_.reversals)
        joint.watch(*coordinate++);
}

// Without ground there are no jumps.
void Trial::watch_body() {
    TrialRecord& record = progress_.record;
    if (progress_.test_ticks % kLengthTicks == 0)
        record.body_length = length_.longest(*scene_, record.body_length);
    if (!record.has_ground) return;
    record.jumps.watch(scene_->ground_gap(), scene_->center_of_mass().dot(record.up));
}

void Trial::sample() {
    TrialRecord& record = progress_.record;
    MotionSample sample{time(), scene_->center_of_mass(), scene_->bounds()};
    if (ground_) {
        sample.ground_low = ground_around(*ground_, sample.bounds.low.x());
        sample.ground_high = ground_around(*ground_, sample.bounds.high.x());
    }
    record.samples.push_back(sample);
    if (record.dimensions == 3) record.supports.push_back(supports_of(*scene_));
    add_to_digest();
}

void Trial::check_guards() {
    const SceneAudit& audit = scene_->audit();
    const TrialSettings& limits = world_.trial;
    if (audit.max_part_speed > limits.max_part_speed) {
        fail(Outcome::kDisqualified, "a part moved faster than the limit");
    } else if (audit.max_part_spin > limits.max_part_spin) {
        fail(Outcome::kDisqualified, "a part spun faster than the limit");
    } else if (audit.max_penetration > limits.max_ground_depth) {
        const bool deep = scene_->ground_gap() < -limits.max_ground_depth;
        progress_.deep_ticks = world_.environment.has_ground && deep ? progress_.deep_ticks + 1 : 0;
        if (progress_.deep_ticks > kDeepTicks)
            fail(Outcome::kDisqualified, "a part sank into the ground");
    }
}

void Trial::fail_with(SceneStatus status) {
    const std::string when = progress_.settling ? " while settling" : "";
    if (status == SceneStatus::kOverBudget) {
        fail(Outcome::kOverBudget,
             fmt::format("the motion is too stiff or too violent to compute{}: it takes more than "
                         "{} evaluations a second",
                         when, short_text(world_.scene.max_evaluations)));
    } else {
        fail(Outcome::kDiverged, "the motion diverged" + when);
    }
}

Trial::State Trial::save() const {
    State state{scene_->save(), creature_.save(), surroundings_.save(), progress_, {}};
    if (bout_) state.bout = bout_->save();
    return state;
}

void Trial::restore(const State& state) {
    const bool had_wall = progress_.wall.has_value();
    progress_ = state.progress;
    if (had_wall || progress_.wall) put_up_wall();
    set_motors_off(state.progress.settling && world_.trial.settle_motors_off);
    scene_->restore(*state.scene);
    if (bout_) bout_->restore(*state.bout, *scene_);
    creature_.restore(state.creature);
    surroundings_.restore(state.surroundings);
}

void Trial::poll_cancel(const std::stop_token& stop) {
    if (progress_.finished || scene_->audit().evaluations <= kLongTrial || !stop.stop_requested())
        return;
    fail(Outcome::kInterrupted, "stopped before its end");
}

void Trial::fail(Outcome outcome, std::string reason) {
    progress_.record.outcome = outcome;
    progress_.record.reason = std::move(reason);
    progress_.settling = false;
    finish();
}

void Trial::finish() {
    progress_.finished = true;
    progress_.record.audit = scene_->audit();
    progress_.record.digest = progress_.digest.value();
    if (bout_) progress_.record.bout = bout_->distances(*scene_);
    int most = 0;
    int all = 0;
    for (const ReversalCounter& joint : progress_.reversals) {
        most = std::max(most, joint.count());
        all += joint.count();
    }
    progress_.record.computed_time = time();
    const bool failed = is_invalid(progress_.record.outcome);
    const double lasted = failed ? time() : static_cast<double>(test_length_) * kBrainTick;
    if (lasted <= 0.0 || progress_.reversals.empty()) return;
    progress_.record.reversal_rate = 0.5 * most / lasted;
    progress_.record.mean_reversal_rate =
        0.5 * all / static_cast<double>(progress_.reversals.size()) / lasted;
}

Result<TrialRecord> run_trial(std::shared_ptr<const Phenotype> phenotype, const Kinds& kinds,
                              const TrialWorld& world, const std::stop_token& stop) {
    auto trial = Trial::start(std::move(phenotype), kinds, world);
    if (!trial) return trial.error();
    while ((*trial)->tick())
        (*trial)->poll_cancel(stop);
    return (*trial)->take_record();
}

}  // namespace cambrian
