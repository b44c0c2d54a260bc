#include "evolution/fields/setting_table.h"
#include "world/terrain.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace cambrian::setting_table {
namespace {

const TerrainSettings& terrain_of(const Settings& settings) {
    return settings.world.environment.terrain;
}

template <std::size_t kCount>
bool is_one_of(const Settings& settings, const std::array<std::string_view, kCount>& kinds) {
    return std::find(kinds.begin(), kinds.end(), terrain_of(settings).kind) != kinds.end();
}

bool has_heights(const Settings& settings) {
    constexpr std::array<std::string_view, 6> kinds = {"rough",  "hills",   "stairs",
                                                       "blocks", "hurdles", "course"};
    return is_one_of(settings, kinds);
}

bool is_spaced(const Settings& settings) {
    constexpr std::array<std::string_view, 6> kinds = {"rough",  "hills", "stairs",
                                                       "blocks", "gaps",  "hurdles"};
    return is_one_of(settings, kinds);
}

bool has_gaps(const Settings& settings) {
    constexpr std::array<std::string_view, 2> kinds = {"gaps", "course"};
    return is_one_of(settings, kinds);
}

bool is_made(const Settings& settings) {
    return !terrain_of(settings).is_flat() && terrain_of(settings).kind != "drawn";
}

bool is_by_chance(const Settings& settings) {
    constexpr std::array<std::string_view, 6> kinds = {"rough", "hills",   "blocks",
                                                       "gaps",  "hurdles", "course"};
    return is_one_of(settings, kinds);
}

void terrain_field(SettingField& field, bool (*applies)(const Settings&)) {
    field.later = true;
    field.applies = applies;
}

void add_terrain_sizes(TableBuilder& world) {
    terrain_field(
        world.number(&TerrainSettings::height, "terrain-height", "Terrain, height", "m",
                     Range{0, 2}, "The height of the highest bump, hill, step, block or hurdle."),
        has_heights);
    terrain_field(world.number(&TerrainSettings::spacing, "terrain-spacing", "Terrain, spacing",
                               "m", Range{0.2, 10},
                               "The distance from one bump, hill, step, block, gap or hurdle to "
                               "the next. By chance it is up to a quarter more or less."),
                  is_spaced);
    terrain_field(
        world.number(&TerrainSettings::gap, "terrain-gap", "Terrain, gap", "m", Range{0.1, 5},
                     "The width of the widest gap; others have half of it or more. All "
                     "are 2 m deep."),
        has_gaps);
    terrain_field(world.number(&TerrainSettings::slope, "terrain-slope", "Terrain, slope", "deg",
                               Range{0, 45},
                               "The angle at which the ground rises away from the start, besides "
                               "its other shape."),
                  is_made);
    terrain_field(
        world.number(&TerrainSettings::pad, "terrain-pad", "Terrain, level start", "m",
                     Range{1, 20}, "The distance from the start up to which the ground is level."),
        is_made);
}

}  // namespace

void add_terrain(TableBuilder& world) {
    terrain_field(
        world.choice(&TerrainSettings::kind, "terrain", "Terrain",
                     {kTerrainIds.begin(), kTerrainIds.end()}, "The shape of the ground."),
        [](const Settings& s) { return s.world.environment.has_ground; });
    add_terrain_sizes(world);
    terrain_field(world.choice(&TerrainSettings::sides, "terrain-sides", "Terrain, sides",
                               {kTerrainSideIds.begin(), kTerrainSideIds.end()},
                               "Both sides of the start are mirror images, so that no creature "
                               "has the easier one, or each has its own shape."),
                  is_made);
    terrain_field(
        world.number(&TerrainSettings::seed, "terrain-seed", "Terrain, number", "", Range{0, 1e9},
                     "The number of this ground among all that chance may draw. The "
                     "same number gives the same ground again."),
        is_by_chance);
    terrain_field(world.flag(&TerrainSettings::same, "terrain-same", "Terrain, always the same",
                             "All trials have the same ground. Otherwise each trial of a creature "
                             "has its own, the same for all creatures, drawn again with the "
                             "trials' other chances."),
                  is_by_chance);
    terrain_field(world.number(&TerrainSettings::level, "terrain-level", "Terrain, level", "",
                               Range{kLeastTerrainLevel, 1},
                               "The share of height, gap and slope that is in force."),
                  is_made);
    terrain_field(world.flag(&TerrainSettings::ladder, "terrain-ladder", "Terrain, ladder",
                             "The level begins as it is set, for example at 0.2, and rises by 0.05 "
                             "before a generation whose median survivor keeps at least 60 % of the "
                             "score that it has at level 0.2."),
                  is_made);
    SettingField& points = world.choice(
        &TerrainSettings::points, "terrain-points", "Terrain, points", {},
        "The points of drawn ground from left to right. It is straight between them and level "
        "beyond the first and the last.");
    points.format = "\"x y; x y; ...\" in m";
    points.check_text = [](const std::string& text) {
        return text.empty() ? Status() : check_ground_points(text);
    };
    terrain_field(points, [](const Settings& s) { return terrain_of(s).kind == "drawn"; });
}

bool is_of_terrain(const SettingField& field) {
    return field.table == "environment" && field.key.starts_with("terrain");
}

Status check_terrain(const Settings& settings) {
    const TerrainSettings& terrain = terrain_of(settings);
    if (terrain.is_flat()) return {};
    if (!settings.world.environment.has_ground)
        return Error{
            "[environment] terrain: there is no ground; set ground = true or terrain = "
            "\"flat\""};
    if (settings.world.trial.has_cube)
        return Error{
            "[environment] terrain: a contest takes place on flat ground; expected "
            "\"flat\""};
    if (settings.world.environment.has_wall)
        return Error{"[environment] terrain: a wall stands on flat ground; expected \"flat\""};
    if (settings.world.environment.has_light && settings.world.environment.light_motion != "still")
        return Error{
            "[environment] terrain: a light that moves needs flat ground; expected \"flat\" "
            "or light-motion = \"still\""};
    if (terrain.kind != "drawn") return {};
    if (Status ground = check_ground_points(terrain.points); !ground)
        return Error{"[environment] terrain-points: " + ground.error().message};
    return {};
}

}  // namespace cambrian::setting_table
