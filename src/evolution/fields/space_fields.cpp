// What settings in three dimensions have besides those of the plane, and what is not built there
// yet.
#include "evolution/fields/setting_table.h"
#include "evolution/settings/goal_defaults.h"
#include "genome/founders/enabled_kinds.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace cambrian::setting_table {
namespace {

constexpr double kSpaceScale = 1000.0;  // of densities, as in adopt_space()

// The units in space of settings that are per length or area in the plane.
struct SpaceUnit {
    std::string_view key;
    const char* unit;
    const char* help;
};

constexpr std::array kSpaceUnits = {
    SpaceUnit{"viscosity-linear", "N s/m^3",
              "The coefficient of linear drag, which grows with the speed of a face, as in syrup."},
    SpaceUnit{"viscosity-quadratic", "kg/m^3",
              "The coefficient of quadratic drag, which grows with the square of the speed of a "
              "face, as in water."},
    SpaceUnit{"density", "kg/m^3", "The mass of a body part for each cubic metre of its volume."},
    SpaceUnit{"muscle-strength", "N/m^2",
              "The largest torque of a joint, divided by the third power of its thinner part's "
              "thickness."},
};

// The senses that work in space.
constexpr std::array<std::string_view, 18> kSensesOfSpace = {
    "joint",          "joint-2",      "joint-rate",       "effort",        "spin",
    "contact-distal", "contact-left", "contact-proximal", "contact-right", "contact-front",
    "contact-back",   "load",         "stretch",          "joint-3",       "joint-rate-2",
    "joint-rate-3",   "effort-2",     "effort-3"};

Status refused(const char* place, const std::string& what) {
    return Error{fmt::format("{}: {} not built in three dimensions yet", place, what)};
}

Status check_senses(const Settings& s, const KindCatalog& catalog) {
    for (const std::uint8_t channel : enabled_channels(s.founders, catalog)) {
        const std::string& id = catalog.channels[channel].id;
        if (std::find(kSensesOfSpace.begin(), kSensesOfSpace.end(), id) == kSensesOfSpace.end())
            return refused("[body.sensors]", fmt::format("the sensor {} is", id));
    }
    const auto organs = enabled_organs(s.founders, catalog);
    return organs.empty() ? Status() : refused("[body.organs]", "organs are");
}

}  // namespace

void adapt_to_space(std::vector<SettingField>& fields) {
    for (SettingField& field : fields) {
        for (const SpaceUnit& space : kSpaceUnits) {
            if (field.key != space.key) continue;
            field.unit = space.unit;
            field.help = space.help;
            field.high *= kSpaceScale;
        }
    }
    std::erase_if(fields, is_of_terrain);
    std::vector<SettingField> added;
    TableBuilder world(added, "environment");
    SettingField& dimensions = world.number(
        &Environment::dimensions, "dimensions", "Dimensions", "", Range{3, 3},
        "The number of dimensions of the world and the bodies in it: 3. Settings without it are of "
        "the plane.");
    dimensions.live = false;
    dimensions.later = true;
    world
        .flag(&Environment::self_contact, "self-contact", "Contact between parts",
              "Parts touch one another, unless a joint connects them or they are nearer than 1 cm "
              "at rest. Otherwise they pass through each other, which costs less time.")
        .later = true;
    const auto insert_before = [&fields, &added](const char* key, std::size_t number) {
        const auto place =
            std::find_if(fields.begin(), fields.end(), [key](const SettingField& field) {
                return field.table == "environment" && field.key == key;
            });
        fields.insert(place, added[number]);
    };
    insert_before("gravity", 0);
    insert_before("viscosity-linear", 1);
}

Status check_space(const Settings& s, const EvolutionKinds& kinds) {
    if (!is_goal_of_space(s.goal)) return refused("[goal] behavior", fmt::format("{} is", s.goal));
    if (s.world.environment.has_light) return refused("[environment] light", "the light is");
    if (s.world.environment.has_wall) return refused("[environment] wall", "walls are");
    if (!s.world.environment.terrain.is_flat())
        return refused("[environment] terrain", "ground with a shape is");
    if (s.world.trial.has_cube) return refused("[trial] cube", "the cube is");
    if (s.expression.strict_overlap)
        return refused("[body] strict-overlap", "the check of overlaps is");
    return check_senses(s, kinds.creature.catalog);
}

}  // namespace cambrian::setting_table
