#include "simulator/contest/bout.h"

#include "simulator/settings/trial_settings.h"
#include "simulator/surroundings/used_senses.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kGap = 1.0;  // m, from the cube to what falls over
constexpr int kHalvings = 50;

BodyPlan cube_plan() {
    PlannedPart cube;
    cube.half_extents = Vec3::Constant(kHalfCube);
    return {.parts = {cube}};
}

// The place of the cube's centre at the start.
Vec3 start_of_cube() {
    return {0.0, kHalfCube, 0.0};
}

double height_of(const PhysicsScene& scene) {
    const Bounds bounds = scene.bounds();
    return bounds.high.y() - bounds.low.y();
}

// Puts a creature in its start pose to the left or the right of the cube (direction -1 or 1).
void place_beside(PhysicsScene& scene, int direction) {
    const Bounds bounds = scene.bounds();
    const double away = kHalfCube + kGap + height_of(scene);
    const double x = direction < 0 ? -away - bounds.high.x() : away - bounds.low.x();
    scene.translate(Vec3(x, kStartClearance - bounds.low.y(), 0.0));
}

// The shortest distance (m) of a part's box to a point.
double distance_to(const PhysicsScene& scene, std::size_t part, const Vec3& point) {
    const Pose pose = scene.part_pose(part);
    const Vec3 inside = pose.orientation.conjugate() * (point - pose.position);
    const Vec3 half = scene.part_half_extents(part);
    const Vec3 beyond(std::max(0.0, std::fabs(inside.x()) - half.x()),
                      std::max(0.0, std::fabs(inside.y()) - half.y()), 0.0);
    return beyond.norm();
}

// The shortest distance (m) of a creature to a point.
double distance_to(const PhysicsScene& scene, const Vec3& point) {
    double nearest = distance_to(scene, 0, point);
    for (std::size_t part = 1; part < scene.part_count(); ++part)
        nearest = std::min(nearest, distance_to(scene, part, point));
    return nearest;
}

// Moves a creature along the ground to that distance (m) from the cube, left or right of it. The
// distance, above the creature's height, falls as its near edge comes from there to the cube.
void bring_to(PhysicsScene& scene, int direction, double distance) {
    const Bounds bounds = scene.bounds();
    const double edge = direction < 0 ? bounds.high.x() : bounds.low.x();
    double far = direction * distance - edge;
    double near = direction * kHalfCube - edge;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (near + far);
        const Vec3 shift(middle, 0.0, 0.0);
        (distance_to(scene, start_of_cube() - shift) < distance ? near : far) = middle;
    }
    scene.translate(Vec3(far, 0.0, 0.0));
}

}  // namespace

Bout::Bout(std::shared_ptr<const Phenotype> opponent, const Kinds& kinds, const BoutWorld& world)
    : phenotype_(std::move(opponent)), kinds_(&kinds), settings_(world.scene) {
    if (!phenotype_) return;
    surroundings_.emplace(world.environment, world.light, senses_of(*phenotype_, kinds));
    creature_ = std::make_unique<Creature>(*phenotype_, kinds, settings_);
    length_ = phenotype_->rest_length();
    is_present_ = true;
}

Result<std::unique_ptr<Bout>> Bout::start(std::shared_ptr<const Phenotype> opponent,
                                          const Kinds& kinds, const BoutWorld& world,
                                          PhysicsScene& own) {
    std::unique_ptr<Bout> bout(new Bout(std::move(opponent), kinds, world));
    if (Status made = bout->make_scenes(world, own); !made) return made.error();
    place_beside(own, -1);
    bout->join(own);
    return bout;
}

Status Bout::make_scenes(const BoutWorld& world, const PhysicsScene& own) {
    const auto make = [&](const BodyPlan& plan) {
        return kinds_->scene.make(plan, world.environment, world.scene);
    };
    auto cube = make(cube_plan());
    if (!cube) return cube.error();
    cube_ = std::move(*cube);
    cube_->translate(start_of_cube() - cube_->center_of_mass());
    workspace_ = cube_->take_workspace();
    SceneSize size = own.size();
    size += cube_->size();
    if (phenotype_) {
        auto opponent = make(phenotype_->plan);
        if (!opponent) return Error{"physics rejects its opponent: " + opponent.error().message};
        opponent_ = std::move(*opponent);
        place_beside(*opponent_, 1);
        size += opponent_->size();
    }
    if (!size.fits(kinds_->scene.largest_join))
        return Error{"the two creatures have too many parts and stretches for one bout"};
    return {};
}

SceneStatus Bout::settle(PhysicsScene& own, double duration) {
    if (is_present_) {
        creature_->hold_rest(*opponent_);
        is_present_ = opponent_->advance(duration) == SceneStatus::kRunning;
    }
    return own.advance(duration);
}

void Bout::begin(PhysicsScene& own) {
    const double other_height = is_present_ ? height_of(*opponent_) : 0.0;
    last_distance_ = kHalfCube + kGap + std::max(height_of(own), other_height);
    bring_to(own, -1, last_distance_);
    if (is_present_) bring_to(*opponent_, 1, last_distance_);
    join(own);
}

void Bout::act(std::uint64_t tick) {
    if (!is_present_) return;
    LightSource& light = surroundings_->source();
    if (light.is_on()) light.move(tick, opponent_->center_of_mass(), length_);
    creature_->act(*opponent_, *surroundings_, kBrainTick);
}

void Bout::pass_on_emissions(std::uint64_t tick) {
    if (!is_present_) return;
    opponent_->list_impacts(impacts_);
    surroundings_->take(creature_->emissions(), impacts_, tick);
}

void Bout::join(PhysicsScene& own) {
    scenes_ = {&own, cube_.get()};
    if (is_present_) scenes_.push_back(opponent_.get());
    joined_ = kinds_->scene.join(scenes_);
}

SceneStatus Bout::advance_joined(double duration) {
    return joined_->advance(scenes_, duration, *workspace_);
}

bool Bout::opponent_fails_alone(double duration) {
    opponent_->mark();
    const bool fails = opponent_->advance(duration) != SceneStatus::kRunning;
    opponent_->go_back();
    return fails;
}

SceneStatus Bout::advance(PhysicsScene& own, double duration) {
    if (status_ != SceneStatus::kRunning) return status_;
    status_ = advance_joined(duration);
    if (status_ != SceneStatus::kRunning && is_present_ && opponent_fails_alone(duration)) {
        last_distance_ = distance_to_cube(*opponent_);
        is_present_ = false;
        join(own);
        status_ = advance_joined(duration);
    }
    return status_;
}

bool Bout::is_calm() const {
    return !is_present_ || opponent_->kinetic_energy() < calm_energy(phenotype_->parts.size());
}

double Bout::distance_to_cube(const PhysicsScene& scene) const {
    return distance_to(scene, cube_->center_of_mass());
}

BoutDistances Bout::distances(const PhysicsScene& own) const {
    return {distance_to_cube(own), is_present_ ? distance_to_cube(*opponent_) : last_distance_};
}

void Bout::set_environment(const Environment& environment) {
    cube_->set_environment(environment);
    if (!opponent_) return;
    opponent_->set_environment(environment);
    surroundings_->set_environment(environment);
}

void Bout::set_motors_off(bool off) {
    if (opponent_) opponent_->set_motors_off(off);
}

void Bout::add_to_digest(Hash64& digest) const {
    cube_->add_to_digest(digest);
    if (is_present_) opponent_->add_to_digest(digest);
}

Bout::State Bout::save() const {
    State state{.cube = cube_->save(),
                .opponent = nullptr,
                .joined = joined_->save(),
                .creature = std::nullopt,
                .surroundings = std::nullopt,
                .status = status_,
                .is_present = is_present_,
                .last_distance = last_distance_};
    if (!opponent_) return state;
    state.opponent = opponent_->save();
    state.creature = creature_->save();
    state.surroundings = surroundings_->save();
    return state;
}

void Bout::restore(const State& state, PhysicsScene& own) {
    cube_->restore(*state.cube);
    if (state.opponent) {
        opponent_->restore(*state.opponent);
        creature_->restore(*state.creature);
        surroundings_->restore(*state.surroundings);
    }
    status_ = state.status;
    last_distance_ = state.last_distance;
    const bool joins_anew = is_present_ != state.is_present;
    is_present_ = state.is_present;
    if (joins_anew) join(own);
    joined_->restore(*state.joined);
}

}  // namespace cambrian
