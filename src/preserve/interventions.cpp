#include "preserve/interventions.h"

#include "core/text/pretty_text.h"
#include "preserve/laws.h"
#include "preserve/world/walls.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr std::uint64_t kPlantsOfAMeal = 10;
constexpr double kMealRadius = 0.6;     // m
constexpr double kEraseDistance = 0.5;  // m; from a wall

Result<std::uint64_t> change_law(const Intervention& asked, PreserveWorld& world,
                                 const Population& population) {
    Result<SettingsPtr> changed = with_law(world.laws, asked, world.kinds);
    if (!changed) return changed.error();
    world.laws = std::move(*changed);
    const Environment environment = world.environment();
    for (const auto& each : population.living())
        each->scene().set_environment(environment);
    return asked.number;
}

// Adds plants around a place, which the light pays. Returns their number.
Result<std::uint64_t> serve(const Vec3& place, PreserveWorld& world) {
    const Energy plant = energy_of(world.laws->preserve.plant_energy);
    std::uint64_t count = 0;
    for (; count < kPlantsOfAMeal && world.energy.light >= plant; ++count) {
        const auto index = static_cast<double>(count);
        const double radius = kMealRadius * std::sqrt(index / kPlantsOfAMeal);
        world.energy.add_plant(place + radius * spiral_direction(index), plant);
    }
    if (count == 0) {
        return Error{
            fmt::format("There is no light left to pay for a plant ({}); it returns as creatures "
                        "move and flesh rots.",
                        measured(joules(plant), "J"))};
    }
    return count;
}

// Returns the number of walls.
std::uint64_t use_walls(std::vector<WallLine> lines, PreserveWorld& world,
                        const Population& population) {
    world.walls.replace(std::move(lines));
    for (const auto& each : population.living())
        each->scene().set_fixed_boxes(world.walls.boxes());
    return world.walls.lines().size();
}

// Returns whether both ends are so deep in the ground that nothing of them is seen.
bool is_buried(const WallLine& wall, const WorldArea& area) {
    constexpr double kDeepest = 0.1;  // m
    const auto is_deep = [&](const Vec3& end) {
        return area.ground && end.y() < area.ground_at(end.x()) - kDeepest;
    };
    return is_deep(wall.from) && is_deep(wall.to);
}

// Builds a wall. Creatures in its way are moved to the nearest place with room.
Result<std::uint64_t> build_wall(const Intervention& asked, PreserveWorld& world,
                                 Population& population) {
    const Vec3 place(asked.x, asked.y, 0.0);
    const Vec3 from = world.area.torus().shortest(place);
    const WallLine wall{from, Vec3(asked.to_x, asked.to_y, 0.0) - (place - from)};
    std::vector<WallLine> lines = world.walls.lines();
    if (lines.size() == static_cast<std::size_t>(kMostFixedBoxes))
        return Error{
            fmt::format("There are {} walls already, the most there can be.", kMostFixedBoxes)};
    if (const Status sound = check_wall(wall, world.area); !sound)
        return Error{fmt::format("This wall cannot be built: {}.", sound.error().message)};
    if (is_buried(wall, world.area))
        return Error{"This wall cannot be built: it is below the ground."};
    lines.push_back(wall);
    if (Status made = population.make_way(DrawnWalls(lines, world.area.torus())); !made)
        return made.error();
    return use_walls(std::move(lines), world, population);
}

Result<std::uint64_t> erase_wall(const Vec3& place, PreserveWorld& world,
                                 const Population& population) {
    const std::optional<std::size_t> index = world.walls.nearest(place, kEraseDistance);
    if (!index) return Error{"There is no wall here to erase."};
    std::vector<WallLine> lines = world.walls.lines();
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(*index));
    return use_walls(std::move(lines), world, population);
}

}  // namespace

Result<std::uint64_t> carry_out(const Intervention& asked, PreserveWorld& world,
                                Population& population) {
    const Vec3 place(asked.x, asked.y, 0.0);
    if (asked.what == intervention::kFeed) return serve(place, world);
    if (asked.what == intervention::kAdd) return population.admit(asked.genome, place);
    if (asked.what == intervention::kWall) return build_wall(asked, world, population);
    if (asked.what == intervention::kErase) return erase_wall(place, world, population);
    if (is_law(asked.what)) return change_law(asked, world, population);
    Status done = Error{fmt::format("the intervention \"{}\" is unknown", asked.what)};
    if (asked.what == intervention::kMove) done = population.move(asked.number, place);
    if (asked.what == intervention::kRemove) done = population.remove(asked.number);
    if (!done) return done.error();
    return asked.number;
}

}  // namespace cambrian
