#include "evolution/fields/setting_table.h"

#include <algorithm>
#include <initializer_list>

namespace cambrian::setting_table {
namespace {

bool has_light(const Settings& settings) {
    return settings.world.environment.has_light;
}

bool has_ground(const Settings& settings) {
    return settings.world.environment.has_ground;
}

bool jumps(const Settings& settings) {
    const std::string& motion = settings.world.environment.light_motion;
    return has_light(settings) && (motion == "jumping" || motion == "hunting");
}

bool wanders(const Settings& settings) {
    return has_light(settings) && settings.world.environment.light_motion == "wandering";
}

void later(SettingField& field, bool (*applies)(const Settings&)) {
    field.later = true;
    field.applies = applies;
}

void add_jumps(TableBuilder& world) {
    later(world.number(
              &Environment::light_nearest, "light-nearest", "Light, nearest", "body lengths",
              Range{0.1, 100},
              "The least distance of a jump of the light from the creature's center of mass."),
          jumps);
    later(world.number(
              &Environment::light_farthest, "light-farthest", "Light, farthest", "body lengths",
              Range{0.1, 100},
              "The greatest distance of a jump of the light. Slow creatures need shorter ways."),
          jumps);
    later(world.number(
              &Environment::light_period, "light-period", "Light, period", "s", Range{0.1, 1000},
              "The time between two jumps of the light. Creatures that turn slowly need more."),
          jumps);
}

void add_light(TableBuilder& world) {
    world
        .flag(&Environment::has_light, "light", "Light",
              "The world has a light, which casts no shadows. Creatures need light sensors to see "
              "it.")
        .later = true;
    later(world.number(&Environment::light_brightness, "light-brightness", "Light, brightness", "",
                       Range{0, 10},
                       "The brightness that a sensor reads at the light. 0 is darkness."),
          has_light);
    later(world.number(
              &Environment::light_x, "light-x", "Light, x", "m", Range{-1000, 1000},
              "The distance of the light to the right of the start. A moving light begins there."),
          has_light);
    later(world.number(&Environment::light_y, "light-y", "Light, y", "m", Range{-1000, 1000},
                       "The height of the light. A moving light begins there."),
          has_light);
    later(world.choice(
              &Environment::light_motion, "light-motion", "Light, motion",
              {kLightMotionIds.begin(), kLightMotionIds.end()},
              "The light stays, jumps again and again to a point around the creature, wanders, or "
              "hunts: it jumps and then follows."),
          has_light);
    later(world.number(
              &Environment::light_range, "light-range", "Light, range", "m", Range{0, 1000},
              "The largest distance of a wandering light from where it begins, in each direction."),
          wanders);
    later(world.number(&Environment::light_reach, "light-reach", "Light, reach", "m",
                       Range{0.1, 100}, "The distance at which half of the brightness is left."),
          has_light);
    add_jumps(world);
}

// Returns whether random creatures may get one of these sensors.
bool senses(const Settings& settings, std::initializer_list<const char*> channels) {
    return std::any_of(channels.begin(), channels.end(), [&](const char* channel) {
        const auto found = settings.founders.channels.find(channel);
        return found != settings.founders.channels.end() && found->second;
    });
}

bool hears(const Settings& settings) {
    return senses(settings, {"sound-1", "sound-2", "sound-3", "sound-4"});
}

bool smells(const Settings& settings) {
    return senses(settings, {"smell", "smell-food", "smell-flesh"});
}

bool has_wall(const Settings& settings) {
    return settings.world.environment.has_wall;
}

void add_wall(TableBuilder& world) {
    world
        .flag(&Environment::has_wall, "wall", "Wall",
              "A wall of 1 m stands on one side, which each trial draws. Creatures need sensors of "
              "obstacles to know where.")
        .later = true;
    later(
        world.number(&Environment::wall_nearest, "wall-nearest", "Wall, nearest", "m",
                     Range{0.1, 100}, "The least distance of the wall from the body at the start."),
        has_wall);
    later(world.number(&Environment::wall_farthest, "wall-farthest", "Wall, farthest", "m",
                       Range{0.1, 100}, "The greatest distance of the wall from the body."),
          has_wall);
    later(world.flag(&Environment::numb, "numbness", "Numbness",
                     "Sensors of obstacles, whiskers and heights of the ground read 0. This is for "
                     "comparisons of evolution with and without them."),
          has_ground);
}

// Switches for comparisons, which do not change what creatures are made of.
void add_missing_senses(TableBuilder& world) {
    later(world.flag(&Environment::deaf, "deafness", "Deafness",
                     "Sensors of sound read 0. This is for comparisons of evolution with and "
                     "without hearing."),
          hears);
    later(world.flag(&Environment::scentless, "anosmia", "No sense of smell",
                     "Sensors of smell read 0. This is for comparisons of evolution with and "
                     "without smell."),
          smells);
}

}  // namespace

void add_environment(std::vector<SettingField>& fields) {
    TableBuilder world(fields, "environment");
    world.number(&Environment::gravity, "gravity", "Gravity", "m/s^2", Range{0, 1000},
                 "The acceleration of free fall. Earth has 9.81, Mars 3.71, the Moon 1.62; the "
                 "swimmers' water has 0.");
    world.number(
        &Environment::gravity_direction, "gravity-direction", "Gravity direction", "deg",
        Range{-180, 180},
        "The direction of gravity, counter-clockwise from the right. -90 is straight down.");
    world.flag(&Environment::has_ground, "ground", "Ground",
               "The ground is an endless floor at height 0.");
    add_terrain(world);
    world.number(&Environment::friction, "friction", "Friction", "", Range{0, 100},
                 "The coefficient of friction between parts and the ground, and between parts. Ice "
                 "has 0.05, rubber 1.");
    world.number(&Environment::elasticity, "elasticity", "Restitution", "", Range{0, 1},
                 "The coefficient of restitution, which is the share of the speed that is left "
                 "after a bounce. Clay has 0, a hard ball 0.9.");
    world.number(
        &Environment::viscosity_linear, "viscosity-linear", "Drag, linear", "N s/m^2",
        Range{0, 1e4},
        "The coefficient of linear drag, which grows with the speed of a face, as in syrup.");
    world.number(&Environment::viscosity_quadratic, "viscosity-quadratic", "Drag, quadratic",
                 "kg/m^2", Range{0, 1e4},
                 "The coefficient of quadratic drag, which grows with the square of the speed of a "
                 "face, as in water.");
    world.number(&Environment::density, "density", "Body density", "kg/m^2", Range{1e-3, 1e4},
                 "The mass of a body part for each square metre of its area.");
    add_light(world);
    add_wall(world);
    add_missing_senses(world);
}

}  // namespace cambrian::setting_table
