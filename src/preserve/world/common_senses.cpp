#include "preserve/world/common_senses.h"

#include "math/angle.h"
#include "simulator/settings/trial_settings.h"

#include <cmath>

namespace cambrian {
namespace {

// Smell that food gives off, for each J and second.
constexpr double kFoodSmell = 0.02;

ScentArea walled(const WorldArea& area) {
    return {.left = area.left(),
            .bottom = area.bottom(),
            .columns = static_cast<int>(std::ceil(area.width / kScentCell)),
            .rows = static_cast<int>(std::ceil(area.height / kScentCell)),
            .wall_left = true,
            .wall_right = true,
            .wall_bottom = true,
            .wall_top = true};
}

void give_off(const Pellets& pellets, ScentField& field) {
    constexpr double amount = kFoodSmell * kTicksPerScentStep * kBrainTick;  // for each J
    for (const Pellet& pellet : pellets.all())
        field.add(pellet.place(), amount * joules(pellet.energy));
}

}  // namespace

CommonSenses::CommonSenses(const WorldArea& area, const Environment& environment)
    : environment_(environment),
      light_(environment, {}, 1.0),
      scent_(walled(area)),
      plants_(walled(area)),
      flesh_(walled(area)) {
    const SineCosine pull = sine_cosine_of_degrees(environment.gravity_direction);
    if (environment.gravity > 0.0) up_ = Vec3(-pull.cosine, -pull.sine, 0.0);
}

double CommonSenses::sound(const Vec3& point, int band, std::uint64_t creature) const {
    return environment_.deaf ? 0.0 : sounds_.at(point, band, static_cast<std::uint32_t>(creature));
}

void CommonSenses::begin_tick() {
    sounds_.clear();
}

void CommonSenses::take(const Emissions& emissions, std::uint64_t creature) {
    for (const Sound& sound : emissions.sounds)
        sounds_.add(sound, static_cast<std::uint32_t>(creature));
    for (const Scent& scent : emissions.scents)
        scent_.add(scent.place, scent.amount);
}

void CommonSenses::end_tick(std::uint64_t tick, const Pellets& plants, const Pellets& flesh) {
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
