// The settings of a preserve: its own table, and those of an experiment that also hold in it.

#include "core/text/number_rows.h"
#include "core/text/number_text.h"
#include "evolution/fields/setting_field.h"
#include "evolution/fields/setting_table.h"
#include "evolution/settings/light_patches.h"
#include "evolution/settings/wall_lines.h"
#include "goals/water.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace cambrian {
namespace {

using setting_table::Range;
using setting_table::Settings;
using setting_table::TableBuilder;

// Tables that describe trials and generations, which a preserve does not have.
constexpr std::array<std::string_view, 5> kForeignTables = {"goal", "trial", "population",
                                                            "selection", "run"};

bool has_ground(const Settings& settings) {
    return settings.world.environment.has_ground;
}

void add_world(TableBuilder& table) {
    table.number(&PreserveSettings::width, "width", "Width", "m", Range{5, 1000},
                 "The distance of the left and the right wall, or the way round the world.");
    table.number(&PreserveSettings::height, "height", "Height", "m", Range{5, 1000},
                 "The distance from the lower wall or, if there is one, the ground to the upper "
                 "wall, or the way round the world.");
    table.choice(&PreserveSettings::edges, "edges", "Edges", {"walls", "wrap"},
                 "Walls are soft and keep creatures in. With wrap, what leaves the world on one "
                 "side enters it on the other; on ground only the left and the right edge meet.");
    table.choice(
        &PreserveSettings::bodies, "bodies", "Bodies", {"solid", "ghostly"},
        "Solid creatures push each other, and bite what they touch. Ghostly ones pass through each "
        "other, and bite what they overlap. They are ghostly by default where there is ground.");
    table.number(&PreserveSettings::founders, "founders", "Founders", "creatures", Range{1, 1000},
                 "The number of creatures at the start.");
    setting_table::add_rhythmic_share(table);
    table.number(&PreserveSettings::max_population, "max-population", "Creatures at most",
                 "creatures", Range{1, 1000},
                 "The number of creatures from which on nobody is born.");
    table.number(
        &PreserveSettings::restock, "restock", "Restock below", "creatures", Range{0, 1000},
        "The number of creatures below which copies of founders are added. 0 means never.");
}

void add_energy(TableBuilder& table) {
    table.number(&PreserveSettings::energy_density, "energy-density", "Energy", "J/m^2",
                 Range{0.1, 1e3},
                 "All the energy of the world, for each square metre. It never changes.");
    table.number(&PreserveSettings::plant_energy, "plant-energy", "Energy of a plant", "J",
                 Range{0.1, 1e4}, "The energy of one plant.");
    table
        .number(&PreserveSettings::plant_height, "plant-height", "Height of plants", "m",
                Range{0, 100},
                "The height above the ground up to which plants grow. Flesh lies on the ground.")
        .applies = has_ground;
    table.number(&PreserveSettings::growth_time, "growth-time", "Growth time", "s", Range{1, 1e6},
                 "The time constant at which the energy of the light becomes plants.");
    table.number(&PreserveSettings::efficiency, "efficiency", "Efficiency", "", Range{0.01, 1},
                 "The share of the energy that a joint takes which becomes work.");
    table.number(&PreserveSettings::body_upkeep, "body-upkeep", "Upkeep of a body", "W/kg",
                 Range{0, 1e3}, "The power that a newborn body needs for each kilogram.");
    table.number(&PreserveSettings::neuron_upkeep, "neuron-upkeep", "Upkeep of a neuron", "W",
                 Range{0, 10}, "The power that each connected neuron of a newborn needs.");
    table.number(&PreserveSettings::organ_upkeep, "organ-upkeep", "Upkeep of organs", "W",
                 Range{0, 100},
                 "The power that a voice or a scent gland needs at its full signal.");
    table.number(&PreserveSettings::aging_time, "aging-time", "Aging time", "s", Range{1, 1e6},
                 "The age at which upkeep is twice that of a newborn. It grows on at that rate.");
    table.number(&PreserveSettings::flesh_half_life, "flesh-half-life", "Half-life of flesh", "s",
                 Range{1, 1e6},
                 "The time after which half of the energy of flesh has become light again.");
}

void add_life(TableBuilder& table) {
    table.number(
        &PreserveSettings::bite_power, "bite-power", "Bite", "W/m", Range{0, 1e5},
        "The power that a mouth takes from what it overlaps, for each metre of its part's width.");
    table.number(&PreserveSettings::ramming, "ramming", "Ramming", "J/J", Range{0, 1e3},
                 "The energy that a mouth takes from what it rams, for each joule of motion that "
                 "the impact takes. Only solid creatures ram.");
    table.number(&PreserveSettings::birth_energy, "birth-energy", "Store at birth", "J/kg",
                 Range{1, 1e5},
                 "The energy that a newborn gets from its parent, for each kilogram.");
    table.number(&PreserveSettings::body_energy, "body-energy", "Energy of a body", "J/kg",
                 Range{0, 1e5}, "The energy that is bound in a body, for each kilogram.");
    table.number(&PreserveSettings::kin_peace, "kin-peace", "Peace of kin", "s", Range{0, 1e6},
                 "The age below which a child and its parents do not bite each other.");
    table.number(&PreserveSettings::birth_interval, "birth-interval", "Time between births", "s",
                 Range{1, 1e6},
                 "The least time between two births of one parent, and the least age of a parent.");
    table.number(&PreserveSettings::mate_distance, "mate-distance", "Mate within", "m",
                 Range{0, 1e3},
                 "The distance up to which a mate is found. Without one, a child has one parent.");
}

template <auto Read>
Status is_read_by(const std::string& text) {
    const auto items = Read(text);
    return items ? Status() : Status(items.error());
}

void add_places(TableBuilder& table) {
    SettingField& walls =
        table.choice(&PreserveSettings::walls, "walls", "Walls", {},
                     "Walls within the world, each with the x and y of both ends. The middle of "
                     "the world or, if there is ground, the middle of the ground is 0 0.");
    walls.format = "\"x y x y; ...\" in m, at most 64";
    walls.check_text = is_read_by<walls_of>;
    SettingField& patches = table.choice(
        &PreserveSettings::patches, "patches", "Patches of light", {},
        "Bright places, each with the x and y of its middle and the standard deviation of where "
        "its plants grow. On ground only x counts. Without any, plants grow everywhere alike.");
    patches.format = "\"x y spread; ...\" in m, at most 64";
    patches.check_text = is_read_by<patches_of>;
}

// Checks each item of a text; `noun` is what one is called.
template <class Item>
Status check_each(const Result<std::vector<Item>>& items, const char* key, const char* noun,
                  const WorldArea& area, Status (*check)(const Item&, const WorldArea&)) {
    if (!items) return Error{fmt::format("[preserve] {}: {}", key, items.error().message)};
    for (std::size_t i = 0; i < items->size(); ++i) {
        if (const Status sound = check((*items)[i], area); !sound)
            return Error{
                fmt::format("[preserve] {}: {} {}: {}", key, noun, i + 1, sound.error().message)};
    }
    return {};
}

Status check_places(const Settings& s) {
    const PreserveSettings& laws = s.preserve;
    const WorldArea area = area_of(laws, s.world.environment);
    if (Status walls = check_each(walls_of(laws.walls), "walls", "wall", area, check_wall); !walls)
        return walls;
    return check_each(patches_of(laws.patches), "patches", "patch", area, check_patch);
}

// Settings of the ground of trials that a world has no use for: it has no start, and what nobody
// can leave or reach would keep the energy of plants for ever.
constexpr std::array<std::string_view, 5> kForeignGround = {
    "terrain-gap", "terrain-sides", "terrain-same", "terrain-level", "terrain-ladder"};
constexpr std::array<std::string_view, 2> kForeignKinds = {"gaps", "course"};

template <std::size_t kCount>
bool is_among(const std::array<std::string_view, kCount>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// Gives settings of the ground their meaning in a world.
void adapt_ground(SettingField& field) {
    if (field.key == "terrain")
        std::erase_if(field.choices, [](const auto& id) { return is_among(kForeignKinds, id); });
    if (field.key == "terrain-pad")
        field.help = "The distance from the middle of the world up to which the ground is level.";
    if (field.key == "terrain-slope")
        field.help =
            "The angle at which the ground rises away from the middle, besides its other shape.";
    if (field.key == "terrain-seed")
        field.help =
            "The number of this ground among all that chance may draw from the world's seed.";
}

Error at_key(const char* key, const std::string& what) {
    return {fmt::format("[environment] {}: {}", key, what)};
}

// Whether the shapes fit between the middle of the world and its edge.
Status check_ground_fits(const Settings& s) {
    constexpr double kFewest = 3.0;  // distances from one shape to the next, on each side
    const TerrainSettings& terrain = s.world.environment.terrain;
    const double room = 0.5 * s.preserve.width - terrain.pad;
    if (room <= 0.0)
        return at_key("terrain-pad",
                      fmt::format("expected less than half of the world's width of {} m, found {} "
                                  "m",
                                  short_text(s.preserve.width), short_text(terrain.pad)));
    if (terrain.kind == "slope" || terrain.spacing * kFewest <= room) return {};
    return at_key(
        "terrain-spacing",
        fmt::format("a world {} m wide has {} m of it on each side of its level middle; "
                    "expected at most a third of that, found {} m",
                    short_text(s.preserve.width), short_text(room), short_text(terrain.spacing)));
}

// Drawn ground lies within the world, and joins itself where edges meet.
Status check_drawn_ground(const Settings& s) {
    const auto rows = number_rows(s.world.environment.terrain.points,
                                  {2, kMostGroundPoints, "point", "\"x y; x y; ...\" in m"});
    if (!rows) return at_key("terrain-points", rows.error().message);
    const double edge = 0.5 * s.preserve.width;
    for (std::size_t i = 0; i < rows->size(); ++i) {
        const double x = (*rows)[i][0];
        if (std::max(x, -x) > edge)
            return at_key("terrain-points",
                          fmt::format("point {} is at x = {} m, outside the world; expected "
                                      "[{}, {}]",
                                      i + 1, short_text(x), short_text(-edge), short_text(edge)));
    }
    const double first = rows->front()[1];
    const double last = rows->back()[1];
    if (!wraps(s.preserve) || first == last) return {};
    return at_key("terrain-points",
                  fmt::format("the first point is at a height of {} m and the last at {} m; "
                              "expected the same, since the edges of the world meet",
                              short_text(first), short_text(last)));
}

Status check_ground(const Settings& s) {
    constexpr double kLeastSky = 2.0;  // m above the highest place
    const TerrainSettings& terrain = s.world.environment.terrain;
    if (terrain.is_flat()) return {};
    if (Status sound = setting_table::check_terrain(s); !sound) return sound;
    if (Status fits = terrain.kind == "drawn" ? check_drawn_ground(s) : check_ground_fits(s); !fits)
        return fits;
    const Result<WorldArea> area = world_area(s);
    if (!area) return at_key("terrain", area.error().message);
    if (!area->ground) return {};
    const double highest = area->ground->heights(area->left(), -area->left()).highest;
    if (highest + kLeastSky <= area->height) return {};
    return at_key("terrain",
                  fmt::format("the ground is up to {:.2f} m high in a world of {} m; expected at "
                              "least {} m above it",
                              highest, short_text(area->height), short_text(kLeastSky)));
}

Status check_world(const Settings& s) {
    if (s.world.environment.has_light && s.world.environment.light_motion != "still")
        return Error{
            fmt::format("[environment] light-motion: a preserve's light does not move; expected "
                        "\"still\", found \"{}\"",
                        s.world.environment.light_motion)};
    return check_ground(s);
}

}  // namespace

double preserve_memory(const PreserveSettings& laws) {
    // Measured; of each, about half is its part of the snapshot that is being written.
    constexpr double per_area = 530.0;      // bytes for each m^2, of smells and of food's places
    constexpr double per_plant = 150.0;     // bytes
    constexpr double per_creature = 6.4e4;  // bytes
    const double area = laws.width * laws.height;
    const double plants = laws.energy_density * area / laws.plant_energy;
    return per_area * area + per_plant * plants +
           per_creature * std::max(laws.founders, laws.max_population);
}

Status check_preserve_memory(const PreserveSettings& laws) {
    const double bytes = preserve_memory(laws);
    if (bytes <= kMostPreserveMemory) return {};
    return Error{
        fmt::format("[preserve] width, height: {} m by {} m with up to {:.3g} plants need about "
                    "{:.3g} GB of memory, at most {:.1f} GB are allowed; expected a smaller world, "
                    "less energy-density or more plant-energy",
                    short_text(laws.width), short_text(laws.height),
                    laws.energy_density * laws.width * laws.height / laws.plant_energy,
                    1e-9 * bytes, 1e-9 * kMostPreserveMemory)};
}

std::vector<SettingField> preserve_fields(const EvolutionKinds& kinds) {
    std::vector<SettingField> fields;
    TableBuilder table(fields, "preserve");
    add_world(table);
    add_energy(table);
    add_life(table);
    add_places(table);
    for (SettingField& field : setting_fields(kinds)) {
        if (is_among(kForeignTables, field.table) && field.key != "seed") continue;
        if (is_among(kForeignGround, field.key)) continue;
        if (setting_table::is_of_terrain(field)) adapt_ground(field);
        fields.push_back(std::move(field));
    }
    return fields;
}

ExperimentSettings preserve_defaults(const EvolutionKinds& kinds, bool has_ground) {
    ExperimentSettings settings;
    if (has_ground) {
        settings.preserve.bodies = "ghostly";
    } else {
        settings.world.environment = water();
    }
    settings.founders.rhythmic_share = 1.0;
    for (const OrganKind& organ : kinds.creature.organs.all()) {
        if (organ.eats) settings.founders.organs[organ.id] = true;
    }
    return settings;
}

Status check_preserve(const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    Settings copy = settings;
    for (const SettingField& field : preserve_fields(kinds)) {
        if (Status fault = setting_table::check_field(field, field.at(copy)); !fault) return fault;
    }
    if (Status world = check_world(settings); !world) return world;
    if (Status places = check_places(settings); !places) return places;
    if (Status fits = check_preserve_memory(settings.preserve); !fits) return fits;
    if (Status order = setting_table::check_founders(settings); !order) return order;
    return setting_table::check_creatures(settings, kinds);
}

}  // namespace cambrian
