// Senses of what comes from afar: light, sound and smells; and of the creature's own hunger.

#include "math/elementary.h"
#include "sensors/frames.h"
#include "sensors/kinds.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr std::size_t kIntensity = 2;    // channel of light; those before are the direction's
constexpr std::size_t kPlants = 0;       // channel of food; the other one smells flesh
constexpr double kMostEnergyRead = 4.0;  // stores at birth

double read_light(const SensorSite& site, double& /*memory*/) {
    const Light light = site.surroundings.light(site.body.part_center(site.index));
    if (site.channel == kIntensity) return limited_reading(light.intensity);
    return component(site, light.direction);
}

Vec3 light_spot(std::size_t channel, int handedness) {
    return channel == kIntensity ? Vec3(Vec3::Zero()) : paired_spot(channel, handedness, 0.75, 0.6);
}

double read_sound(const SensorSite& site, double& /*memory*/) {
    const Vec3 center = site.body.part_center(site.index);
    return limited_reading(site.surroundings.sound(center, static_cast<int>(site.channel)));
}

// Returns 1 at an obstacle and 0 from the end of reach on. The logarithm leaves the nearer half of
// the readings to the nearest 3 m and still tells farther sides apart.
double nearness(double distance) {
    constexpr double kReach = 16.0;  // m
    if (!(distance < kReach)) return 0.0;
    return 1.0 - logarithm(1.0 + distance) / logarithm(1.0 + kReach);
}

double read_obstacle(const SensorSite& site, double& /*memory*/) {
    const int direction = (site.channel == 0 ? -1 : 1) * site.mirror.across;
    return nearness(site.surroundings.obstacle(site.body.part_center(site.index), direction));
}

// Returns the reading of a nose at a concentration: its logarithm, so that the difference of two
// noses is the same however strong the smell is.
double smell_reading(double concentration) {
    constexpr double kLeast = 1e-3;  // units; less is hardly noticed
    constexpr double kScale = 0.25;
    constexpr double kMost = 5.0;
    return std::min(kMost, kScale * logarithm(1.0 + concentration / kLeast));
}

// Returns the place of a nose, the part's far end.
Vec3 nose_of(const SensorSite& site) {
    return point_on_axis(site.body, site.index, 1.0);
}

double read_food_smell(const SensorSite& site, double& /*memory*/) {
    return smell_reading(site.channel == kPlants ? site.surroundings.plant_smell(nose_of(site))
                                                 : site.surroundings.flesh_smell(nose_of(site)));
}

}  // namespace

// Light: the direction to it along and across the part (Sims 1994), and its intensity at the part's
// centre. No part casts a shadow.
void add_light_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "light",
                 .label = "Light",
                 .group = "Light",
                 .channels = {{"light-along", "Light, along"},
                              {"light-across", "Light, across"},
                              {"light", "Light, intensity"}},
                 .read = read_light,
                 .spot = light_spot,
                 .sees = true,
                 .usual = false});
}

// Obstacles from afar: how near one is to the left and to the right of the part's centre, in the
// world. Left and right are exchanged on mirrored parts.
void add_obstacle_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "obstacle",
                 .label = "Obstacles",
                 .group = "Obstacles",
                 .channels = {{"obstacle-left", "Obstacle to the left"},
                              {"obstacle-right", "Obstacle to the right"}},
                 .read = read_obstacle,
                 .spot =
                     [](std::size_t channel, int handedness) {
                         return Vec3(0.0, (channel == 0 ? 0.5 : -0.5) * handedness, 0.0);
                     },
                 .usual = false});
}

// Ears: the loudness of each of the four bands of sound at the part's centre, with lamps in a row
// across the part. A creature does not hear itself.
void add_sound_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "sound",
                 .label = "Sound",
                 .group = "Sound",
                 .channels = {{"sound-1", "Sound, band 1"},
                              {"sound-2", "Sound, band 2"},
                              {"sound-3", "Sound, band 3"},
                              {"sound-4", "Sound, band 4"}},
                 .read = read_sound,
                 .spot =
                     [](std::size_t channel, int handedness) {
                         return Vec3(0.1, handedness * (0.45 - 0.3 * static_cast<double>(channel)),
                                     0.0);
                     },
                 .usual = false});
}

// Nose: the logarithm of the concentration of scent.
void add_smell_sensor(SensorRegistry& sensors) {
    sensors.add(
        {.id = "smell",
         .label = "Smell",
         .group = "Smell",
         .channels = {{"smell", "Smell"}},
         .read = [](const SensorSite& site,
                    double&) { return smell_reading(site.surroundings.scent(nose_of(site))); },
         .spot = [](std::size_t, int) { return Vec3(0.9, 0.0, 0.0); },
         .smells = true,
         .usual = false});
}

// Noses for what can be eaten in a preserve, side by side: the smell of plants and of flesh.
void add_food_smell_sensor(SensorRegistry& sensors) {
    sensors.add({.id = "smell-of-food",
                 .label = "Smell of food",
                 .group = "Smell",
                 .channels = {{"smell-food", "Smell of plants"}, {"smell-flesh", "Smell of flesh"}},
                 .read = read_food_smell,
                 .spot =
                     [](std::size_t channel, int handedness) {
                         return Vec3(0.7, handedness * (0.3 - 0.6 * static_cast<double>(channel)),
                                     0.0);
                     },
                 .usual = false});
}

// Hunger: the creature's own store of energy, as a share of that of a newborn. It is 0 outside of a
// preserve.
void add_hunger_sensor(SensorRegistry& sensors) {
    sensors.add(
        {.id = "stored-energy",
         .label = "Hunger",
         .group = "Hunger",
         .channels = {{"energy", "Energy left"}},
         .read = [](const SensorSite& site,
                    double&) { return std::min(kMostEnergyRead, site.surroundings.energy()); },
         .usual = false});
}

}  // namespace cambrian
