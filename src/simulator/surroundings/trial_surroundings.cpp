#include "simulator/surroundings/trial_surroundings.h"

#include "math/angle.h"
#include "simulator/surroundings/ground_ray.h"
#include "simulator/surroundings/impact_noise.h"
#include "simulator/surroundings/side_wall.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

constexpr int kColumns = 128;  // 64 m around the start
constexpr int kRows = 64;      // 32 m

bool has_floor(const Environment& environment) {
    return environment.has_ground && environment.terrain.is_flat();
}

// Without a floor, the area is around the start in both directions, with open edges.
ScentArea scent_area(const Environment& environment) {
    const double height = kRows * kScentCell;
    return {.left = -0.5 * kColumns * kScentCell,
            .bottom = has_floor(environment) ? 0.0 : -0.5 * height,
            .columns = kColumns,
            .rows = kRows,
            .wall_bottom = has_floor(environment)};
}

}  // namespace

TrialSurroundings::TrialSurroundings(const Environment& environment, const LightDraw& draw,
                                     const UsedSenses& used)
    : environment_(environment), used_(used), source_(environment, draw) {
    sounds_.reserve(used.voices + kMostImpacts);
    find_up();
    find_ground();
    lay_out_field();
}

void TrialSurroundings::set_environment(const Environment& environment) {
    const bool moved_floor = has_floor(environment) != has_floor(environment_);
    const bool other_shape = !(environment.terrain == environment_.terrain);
    environment_ = environment;
    find_up();
    if (other_shape) find_ground();
    source_.set_environment(environment);
    if (moved_floor) lay_out_field();
}

void TrialSurroundings::find_up() {
    const SineCosine pull = sine_cosine_of_degrees(environment_.gravity_direction);
    up_ = environment_.gravity > 0.0 ? Vec3(-pull.cosine, -pull.sine, 0.0) : Vec3(Vec3::Zero());
}

void TrialSurroundings::find_ground() {
    terrain_.reset();
    if (!used_.feels_ground || environment_.terrain.is_flat()) return;
    if (auto terrain = Terrain::make(environment_.terrain)) terrain_ = std::move(*terrain);
}

void TrialSurroundings::lay_out_field() {
    field_.reset();
    if (used_.scents || used_.smells) field_.emplace(scent_area(environment_));
}

double TrialSurroundings::scent(const Vec3& point) const {
    return environment_.scentless || !field_ ? 0.0 : field_->at(point);
}

double TrialSurroundings::obstacle(const Vec3& point, int direction) const {
    if (environment_.numb || wall_ == nullptr) return Surroundings::obstacle(point, direction);
    return distance_to_wall(*wall_, point, direction);
}

double TrialSurroundings::distance_to_ground(const Vec3& from, const Vec3& direction,
                                             double reach) const {
    if (environment_.numb) return Surroundings::distance_to_ground(from, direction, reach);
    double nearest = Surroundings::distance_to_ground(from, direction, reach);
    if (environment_.has_ground)
        nearest = terrain_ ? distance_to_terrain(*terrain_, from, direction, reach)
                           : distance_to_level_ground(from, direction);
    if (wall_ != nullptr) nearest = std::min(nearest, distance_to_box(*wall_, from, direction));
    return nearest;
}

double TrialSurroundings::ground_height(double x) const {
    return environment_.numb || !environment_.has_ground || !terrain_ ? 0.0 : terrain_->height(x);
}

void TrialSurroundings::take_all(const Emissions& emissions, std::span<const SceneImpact> impacts,
                                 std::uint64_t tick) {
    sounds_.assign(emissions.sounds.begin(), emissions.sounds.end());
    add_noise(impacts, sounds_);
    if (!field_) return;
    for (const Scent& scent : emissions.scents)
        field_->add(scent.place, scent.amount);
    if ((tick + 1) % kTicksPerScentStep == 0) field_->step();
}

bool TrialSurroundings::changes() const {
    return source_.moves() || (used_.smells && !environment_.scentless && field_ && field_->any());
}

TrialSurroundings::Moment TrialSurroundings::save() const {
    return {source_.save(), sounds_, field_ ? field_->save() : ScentField::Moment{}};
}

void TrialSurroundings::restore(const Moment& moment) {
    source_.restore(moment.light);
    sounds_.assign(moment.sounds.begin(), moment.sounds.end());
    if (field_) field_->restore(moment.scent);
}

}  // namespace cambrian
