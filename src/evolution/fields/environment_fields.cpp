#include "evolution/fields/setting_table.h"

namespace cambrian::setting_table {
namespace {

bool has_light(const Settings& settings) {
    return settings.world.environment.has_light;
}

bool wanders(const Settings& settings) {
    return has_light(settings) && settings.world.environment.light_motion == "wandering";
}

void add_light(TableBuilder& world) {
    const auto later = [](SettingField& field, bool (*applies)(const Settings&)) {
        field.later = true;
        field.applies = applies;
    };
    world
        .flag(
            "light", "Light", "A light that casts no shadows; creatures need senses to see it.",
            [](Settings & s) -> auto& { return s.world.environment.has_light; })
        .later = true;
    later(world.number(
              "light-brightness", "Light, brightness", "", Range{0, 10},
              "What the sense of light reads at the light; 0 is darkness.",
              [](Settings & s) -> auto& { return s.world.environment.light_brightness; }),
          has_light);
    later(world.number(
              "light-x", "Light, across", "m", Range{-1000, 1000},
              "Place of the light to the right of the start; where it begins if it moves.",
              [](Settings & s) -> auto& { return s.world.environment.light_x; }),
          has_light);
    later(world.number(
              "light-y", "Light, up", "m", Range{-1000, 1000},
              "Height of the light; where it begins if it moves.",
              [](Settings & s) -> auto& { return s.world.environment.light_y; }),
          has_light);
    later(world.choice(
              "light-motion", "Light, motion", {kLightMotionIds.begin(), kLightMotionIds.end()},
              "Stays; jumps every 5 s to somewhere 3 to 6 body lengths from the creature; or "
              "wanders about.",
              [](Settings & s) -> auto& { return s.world.environment.light_motion; }),
          has_light);
    later(world.number(
              "light-range", "Light, range", "m", Range{0, 1000},
              "How far it wanders from where it begins, each way.",
              [](Settings & s) -> auto& { return s.world.environment.light_range; }),
          wanders);
    later(world.number(
              "light-reach", "Light, reach", "m", Range{0.1, 100},
              "Distance at which half of the light is left.",
              [](Settings & s) -> auto& { return s.world.environment.light_reach; }),
          has_light);
}

}  // namespace

void add_environment(std::vector<SettingField>& fields) {
    TableBuilder world(fields, "environment");
    world.number(
        "gravity", "Gravity", "m/s^2", Range{0, 1000},
        "Pull of the world: Earth 9.81, Mars 3.71, Moon 1.62, a swimmer's water 0.",
        [](Settings & s) -> auto& { return s.world.environment.gravity; });
    world.number(
        "gravity-direction", "Gravity direction", "deg", Range{-180, 180},
        "Where the pull points, counter-clockwise from right; -90 is straight down.",
        [](Settings & s) -> auto& { return s.world.environment.gravity_direction; });
    world.flag(
        "ground", "Ground", "A flat endless floor at height 0.",
        [](Settings & s) -> auto& { return s.world.environment.has_ground; });
    world.number(
        "friction", "Friction", "", Range{0, 100},
        "Grip of the ground and of parts on each other; ice 0.05, rubber 1.",
        [](Settings & s) -> auto& { return s.world.environment.friction; });
    world.number(
        "elasticity", "Elasticity", "", Range{0, 1},
        "Share of the speed kept in a bounce: clay 0, a hard ball 0.9.",
        [](Settings & s) -> auto& { return s.world.environment.elasticity; });
    world.number(
        "viscosity-linear", "Viscosity, linear", "N s/m^2", Range{0, 1e4},
        "Drag that grows with a face's speed, as in treacle.",
        [](Settings & s) -> auto& { return s.world.environment.viscosity_linear; });
    world.number(
        "viscosity-quadratic", "Viscosity, quadratic", "kg/m^2", Range{0, 1e4},
        "Drag that grows with the square of a face's speed, as in water.",
        [](Settings & s) -> auto& { return s.world.environment.viscosity_quadratic; });
    world.number(
        "density", "Body density", "kg/m^2", Range{1e-3, 1e4},
        "Mass of a body part for each square metre of it.",
        [](Settings & s) -> auto& { return s.world.environment.density; });
    add_light(world);
}

}  // namespace cambrian::setting_table
