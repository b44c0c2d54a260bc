// Noses for what can be eaten in a preserve: the logarithm of the concentration of the smell of
// plants and of flesh at the part's far end.

#include "sensors/kinds.h"
#include "sensors/smelling.h"

namespace cambrian {
namespace {

constexpr std::size_t kPlants = 0;  // channel; the other one smells flesh

double read_food_smell(const SensorSite& site, double& /*memory*/) {
    const Vec3 nose = point_on_axis(site.body, site.index, 1.0);
    return smell_reading(site.channel == kPlants ? site.surroundings.plant_smell(nose)
                                                 : site.surroundings.flesh_smell(nose));
}

// Places the noses side by side.
Vec3 food_smell_spot(std::size_t channel, int handedness) {
    return {0.7, handedness * (0.3 - 0.6 * static_cast<double>(channel)), 0.0};
}

}  // namespace

void add_food_smell_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "smell-of-food",
                 .label = "Smell of food",
                 .group = "Smell",
                 .channels = {{"smell-food", "Smell of plants"}, {"smell-flesh", "Smell of flesh"}},
                 .read = read_food_smell,
                 .spot = food_smell_spot,
                 .usual = false});
}

}  // namespace cambrian
