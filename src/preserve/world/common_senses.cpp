#include "preserve/world/common_senses.h"

#include "math/angle.h"
#include "simulator/settings/trial_settings.h"
#include "simulator/surroundings/ground_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cambrian {
namespace {

// Smell that food gives off, for each J and second.
constexpr double kFoodSmell = 0.02;

// Returns the number of cells in a length. Between edges that meet they are complete.
int cells_in(double length, bool meet) {
    const double cells = length / kScentCell;
    return static_cast<int>(meet ? std::round(cells) : std::ceil(cells));
}

ScentArea scent_area(const WorldArea& area) {
    const Torus torus = area.torus();
    const int columns = cells_in(area.width, torus.width > 0.0);
    const int rows = cells_in(area.top() - area.bottom(), torus.height > 0.0);
    return {.left = torus.width > 0.0 ? -0.5 * kScentCell * columns : area.left(),
            .bottom = torus.height > 0.0 ? -0.5 * kScentCell * rows : area.bottom(),
            .columns = columns,
            .rows = rows,
            .wall_left = true,
            .wall_right = true,
            .wall_bottom = true,
            .wall_top = true,
            .sides_meet = torus.width > 0.0,
            .ends_meet = torus.height > 0.0};
}

// Returns by how much a period is stretched to be that of a field.
double stretch(double period, int cells) {
    return period > 0.0 ? kScentCell * cells / period : 1.0;
}

}  // namespace

CommonSenses::CommonSenses(const WorldArea& area, const Environment& environment,
                           const DrawnWalls* walls)
    : environment_(environment),
      torus_(area.torus()),
      ground_(area.ground),
      walls_(walls),
      light_(environment, {}),
      sounds_(torus_),
      scent_(scent_area(area)),
      plants_(scent_area(area)),
      flesh_(scent_area(area)) {
    const ScentArea& cells = scent_.area();
    stretch_ = {stretch(torus_.width, cells.columns), stretch(torus_.height, cells.rows), 1.0};
    const SineCosine pull = sine_cosine_of_degrees(environment.gravity_direction);
    if (environment.gravity > 0.0) up_ = Vec3(-pull.cosine, -pull.sine, 0.0);
}

// If edges meet, the light is at its nearest image.
Light CommonSenses::light(const Vec3& point) const {
    if (!torus_.meets()) return light_.at(point);
    return light_.at(light_.place() - torus_.shortest(light_.place() - point));
}

double CommonSenses::sound(const Vec3& point, int band, std::uint64_t creature) const {
    if (environment_.deaf) return 0.0;
    return sounds_.at(torus_.shortest(point), band, static_cast<std::uint32_t>(creature));
}

// Returns where a point is in the fields, whose cells are stretched to go round a world exactly.
Vec3 CommonSenses::in_fields(const Vec3& point) const {
    if (!torus_.meets()) return point;
    return torus_.shortest(point).cwiseProduct(stretch_);
}

double CommonSenses::distance_to_ground(const Vec3& from, const Vec3& direction,
                                        double reach) const {
    if (!ground_ || environment_.numb) return std::numeric_limits<double>::infinity();
    const double ground = distance_to_terrain(*ground_, from, direction, reach);
    return walls_ == nullptr ? ground : std::min(ground, walls_->distance(from, direction, reach));
}

void CommonSenses::give_off(const Food& pellets, ScentField& field) const {
    constexpr double amount = kFoodSmell * kTicksPerScentStep * kBrainTick;  // for each J
    for (const Pellet& pellet : pellets.all())
        field.add(in_fields(pellet.place()), amount * joules(pellet.energy));
}

void CommonSenses::begin_tick() {
    sounds_.clear();
}

void CommonSenses::take(const Emissions& emissions, std::uint64_t creature) {
    for (Sound sound : emissions.sounds) {
        sound.place = torus_.shortest(sound.place);
        sounds_.add(sound, static_cast<std::uint32_t>(creature));
    }
    for (const Scent& scent : emissions.scents)
        scent_.add(in_fields(scent.place), scent.amount);
}

void CommonSenses::end_tick(std::uint64_t tick, const Food& plants, const Food& flesh) {
    sounds_.finish();
    if (tick % kTicksPerScentStep != 0) return;
    give_off(plants, plants_);
    give_off(flesh, flesh_);
    scent_.step();
    plants_.step();
    flesh_.step();
}

void CommonSenses::restore(const Moment& moment) {
    sounds_.clear();
    sounds_.finish();
    scent_.restore(moment.scent);
    plants_.restore(moment.plants);
    flesh_.restore(moment.flesh);
}

std::size_t CommonSenses::cells() const {
    return scent_.cell_count();
}

}  // namespace cambrian
