// What people do to a preserve between two ticks (preserve/README.md 8).

#include "core/text/pretty_text.h"
#include "preserve/laws.h"
#include "preserve/life/feeding.h"
#include "preserve/preserve.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr std::uint64_t kPlantsOfAMeal = 10;
constexpr double kMealRadius = 0.6;  // m
constexpr const char* kNoRoom = "There is no room: other creatures are in the way.";
constexpr double kEraseDistance = 0.5;  // m; from a wall

std::string joules_text(Energy energy) {
    return measured(joules(energy), "J");
}

}  // namespace

Result<std::uint64_t> Preserve::intervene(Intervention asked) {
    if (!std::isfinite(asked.x) || !std::isfinite(asked.y) || !std::isfinite(asked.to_x) ||
        !std::isfinite(asked.to_y))
        return Error{"the place of an intervention is not finite"};
    asked.tick = tick_;
    Result<std::uint64_t> number = carry_out(asked);
    if (!number) return number;
    asked.number = *number;
    chronicle_.interventions.push_back(std::move(asked));
    return number;
}

Result<std::uint64_t> Preserve::carry_out(const Intervention& asked) {
    const Vec3 place(asked.x, asked.y, 0.0);
    if (asked.what == intervention::kRest) {
        rest();
        return asked.number;
    }
    if (asked.what == intervention::kFeed) return serve(place);
    if (asked.what == intervention::kAdd) return admit(asked.genome, place);
    if (asked.what == intervention::kWall) {
        const Vec3 from = area_.torus().shortest(place);
        return build_wall({from, Vec3(asked.to_x, asked.to_y, 0.0) - (place - from)});
    }
    if (asked.what == intervention::kErase) return erase_wall(place);
    if (is_law(asked.what)) {
        if (Status changed = change_law(asked); !changed) return changed.error();
        return asked.number;
    }
    const auto found = std::find_if(residents_.begin(), residents_.end(), [&](const auto& each) {
        return each->life.number == asked.number;
    });
    if (found == residents_.end())
        return Error{fmt::format("creature {} is not alive", asked.number)};
    if (asked.what == intervention::kMove) {
        const std::optional<Vec3> free = room().nearest(place, **found);
        if (!free) return Error{kNoRoom};
        (*found)->place(*free, Vec3::Zero());
        return asked.number;
    }
    if (asked.what != intervention::kRemove)
        return Error{fmt::format("the intervention \"{}\" is unknown", asked.what)};
    (*found)->life.cause = DeathCause::kRemoved;
    end_life(**found, std::max<std::uint64_t>(1, tick_));  // 0 means alive
    residents_.erase(found);
    forget_lineages();
    return asked.number;
}

Status Preserve::change_law(const Intervention& asked) {
    Result<SettingsPtr> changed = with_law(laws_, asked, kinds_);
    if (!changed) return changed.error();
    use_laws(std::move(*changed));
    return {};
}

void Preserve::use_laws(SettingsPtr laws) {
    laws_ = std::move(laws);
    for (const auto& each : residents_)
        each->scene().set_environment(laws_->world.environment);
}

// Adds plants around a place, which the light pays. Returns their number.
Result<std::uint64_t> Preserve::serve(const Vec3& place) {
    const Energy plant = energy_of(laws_->preserve.plant_energy);
    std::uint64_t count = 0;
    for (; count < kPlantsOfAMeal && ambient_ >= plant; ++count) {
        const auto index = static_cast<double>(count);
        const double radius = kMealRadius * std::sqrt(index / kPlantsOfAMeal);
        plants_.add(place + radius * spiral_direction(index), plant);
        ambient_ -= plant;
    }
    if (count == 0) {
        return Error{
            fmt::format("There is no light left to pay for a plant ({}); it returns as creatures "
                        "move and flesh rots.",
                        joules_text(plant))};
    }
    return count;
}

// Builds a wall. Creatures in its way are moved to the nearest place with room. Returns the number
// of walls.
Result<std::uint64_t> Preserve::build_wall(const WallLine& wall) {
    if (walls_.lines().size() == static_cast<std::size_t>(kMostFixedBoxes))
        return Error{
            fmt::format("There are {} walls already, the most there can be.", kMostFixedBoxes)};
    if (const Status sound = check_wall(wall, area_); !sound)
        return Error{fmt::format("This wall cannot be built: {}.", sound.error().message)};
    std::vector<WallLine> lines = walls_.lines();
    lines.push_back(wall);
    if (Status made = make_way(DrawnWalls(lines, area_.torus())); !made) return made.error();
    use_walls(std::move(lines));
    return walls_.lines().size();
}

// Moves all creatures that these walls meet, or none.
Status Preserve::make_way(const DrawnWalls& walls) {
    std::vector<Resident*> movers;
    std::vector<Vec3> places;
    std::vector<Bounds> taken;
    const Room room(area_, walls, residents_, solid_ != nullptr);
    for (const auto& each : residents_) {
        if (!walls.meet(each->rectangles())) continue;
        const std::optional<Vec3> place = room.nearest(each->center(), *each, taken);
        if (!place) return Error{"There is no room for the creatures in the way of this wall."};
        movers.push_back(each.get());
        places.push_back(*place);
        taken.push_back(moved(each->bounds(), *place - each->center()));
    }
    for (std::size_t i = 0; i < movers.size(); ++i)
        movers[i]->place(places[i], Vec3::Zero());
    return {};
}

void Preserve::use_walls(std::vector<WallLine> lines) {
    walls_.replace(std::move(lines));
    for (const auto& each : residents_)
        each->scene().set_fixed_boxes(walls_.boxes());
}

// Returns the number of walls that are left.
Result<std::uint64_t> Preserve::erase_wall(const Vec3& place) {
    const std::optional<std::size_t> index = walls_.nearest(place, kEraseDistance);
    if (!index) return Error{"There is no wall here to erase."};
    std::vector<WallLine> lines = walls_.lines();
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(*index));
    use_walls(std::move(lines));
    return walls_.lines().size();
}

// Adds a creature at a place, which the light pays. Returns its number.
Result<std::uint64_t> Preserve::admit(const GenomePtr& genome, const Vec3& place) {
    if (!genome) return Error{"a creature to add has no genotype"};
    Life life{.number = next_number_, .method = "added", .genome = genome, .born = tick_};
    life.uid = newcomer_uid();
    auto grown = Resident::grow(std::move(life), kinds_.creature, *settings_, senses_);
    if (!grown)
        return Error{fmt::format("The creature cannot live here: {}.", grown.error().message)};
    Resident& resident = **grown;
    if (!resident.can_move())
        return Error{
            "The creature cannot live here: none of its joints follows more than constants."};
    const std::optional<Vec3> center = room().nearest(place, resident);
    if (!center) return Error{kNoRoom};
    if (!area_.holds(*center, resident.radius()))
        return Error{"The creature is too large for the world."};
    if (!afford(resident)) {
        return Error{
            fmt::format("The light and the plants have {} left, and the creature costs {}.",
                        joules_text(ambient_ + plants_.energy()), joules_text(price_of(resident)))};
    }
    resident.place(*center, Vec3::Zero());
    const std::uint64_t number = next_number_;
    settle(*std::move(grown));
    feel_energy();
    return number;
}

}  // namespace cambrian
