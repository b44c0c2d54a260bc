#include "preserve/preserve_world.h"

#include "core/assert.h"
#include "math/elementary.h"
#include "preserve/world/walls.h"

#include <utility>

namespace cambrian {
namespace {

constexpr std::uint64_t kTicksPerRot = 6;  // 0.1 s
constexpr int kPlantPlaceDraws = 20;       // for a plant of a patch, within the world

template <class Value>
Value checked(Result<Value> value) {
    CAMBRIAN_ASSERT(value.has_value(), "settings that were checked");
    return *std::move(value);
}

Ledger founding_ledger(const PreserveSettings& settings, const WorldArea& area) {
    const Energy all = energy_of(settings.energy_density * area.width * area.height);
    return {all, all, Food(area, settings.plant_height), Food(area, 0.0)};
}

// Returns the walls of the settings, whose heights are those above the ground.
std::vector<WallLine> founding_walls(const PreserveSettings& settings, const WorldArea& area) {
    std::vector<WallLine> walls = checked(walls_of(settings.walls));
    if (!area.ground) return walls;
    for (WallLine& wall : walls) {
        for (Vec3* end : {&wall.from, &wall.to})
            end->y() = std::min(end->y() + area.ground_at(end->x()), area.top());
    }
    return walls;
}

// Returns where a plant grows: anywhere or, if there are patches of light, around one of them. On
// ground, the height of a plant does not depend on light.
Vec3 draw_bright_place(const PreserveWorld& world, RandomStream& draws) {
    const WorldArea& area = world.area;
    const auto draw_y = [&](double x) {
        return area.has_ground
                   ? area.ground_at(x) + world.settings->preserve.plant_height * draws.uniform()
                   : area.height * (draws.uniform() - 0.5);
    };
    for (int draw = 0; draw < kPlantPlaceDraws && !world.patches.empty(); ++draw) {
        const LightPatch& patch = world.patches[draws.below(world.patches.size())];
        const double x = draws.gauss();
        const double y = draws.gauss();
        Vec3 place = patch.center + patch.spread * Vec3(x, y, 0.0);
        if (area.has_ground) place.y() = draw_y(place.x());
        if (area.holds(place, 0.0)) return place;
    }
    const double x = area.width * (draws.uniform() - 0.5);
    return {x, draw_y(x), 0.0};
}

}  // namespace

PreserveWorld::PreserveWorld(SettingsPtr founding, const EvolutionKinds& all_kinds)
    : settings(std::move(founding)),
      laws(settings),
      kinds(all_kinds),
      area(checked(world_area(*settings))),
      senses(area, settings->world.environment, &walls),
      walls(founding_walls(settings->preserve, area), area.torus()),
      patches(checked(patches_of(settings->preserve.patches))),
      energy(founding_ledger(settings->preserve, area)) {}

std::uint64_t PreserveWorld::seed(std::uint64_t index, PreserveUse use) const {
    return stream_seed(settings->seed, index, static_cast<std::uint64_t>(use), Purpose::kPreserve);
}

void PreserveWorld::sow() {
    RandomStream draws = stream(0, PreserveUse::kSowing);
    const Energy after = energy.light / 2;
    const Energy plant = energy_of(settings->preserve.plant_energy);
    while (energy.light - plant >= after)
        energy.add_plant(draw_bright_place(*this, draws), plant);
}

void PreserveWorld::grow_plants() {
    const PreserveSettings& rules = laws->preserve;
    const Energy plant = energy_of(rules.plant_energy);
    const double expected =
        joules(energy.light) / (rules.growth_time * rules.plant_energy) * kBrainTick;
    RandomStream draws = stream(tick, PreserveUse::kGrowth);
    auto count = static_cast<std::uint64_t>(expected);
    if (draws.chance(expected - static_cast<double>(count))) ++count;
    for (; count > 0 && energy.light >= plant; --count)
        energy.add_plant(draw_bright_place(*this, draws), plant);
    if (tick % kTicksPerRot != 0) return;
    const double time = kTicksPerRot * kBrainTick;
    energy.light +=
        energy.flesh.rot(1.0 - exponential(-logarithm(2.0) * time / rules.flesh_half_life));
}

}  // namespace cambrian
