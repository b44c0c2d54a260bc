#include "evolution/settings/world_area.h"

#include "core/random.h"
#include "core/text/number_text.h"
#include "evolution/settings/experiment_settings.h"

#include <fmt/core.h>

namespace cambrian {

// Drawn ground between walls goes on level, as in a trial.
Environment world_environment(const ExperimentSettings& settings) {
    constexpr std::uint64_t kWorldGround = 105;  // separates the draws of the ground from others
    Environment environment = settings.world.environment;
    TerrainSettings& terrain = environment.terrain;
    if (terrain.is_flat()) return environment;
    terrain.seed = stream_seed({terrain.seed, settings.seed, kWorldGround});
    const bool is_drawn = terrain.kind == "drawn";
    if (!is_drawn || wraps(settings.preserve)) terrain.world_width = settings.preserve.width;
    return environment;
}

Result<WorldArea> world_area(const ExperimentSettings& settings) {
    const Environment environment = world_environment(settings);
    WorldArea area = area_of(settings.preserve, environment);
    Result<std::shared_ptr<const Terrain>> ground = Terrain::make(environment.terrain);
    if (!ground) return ground.error();
    area.ground = *std::move(ground);
    if (area.ground)
        area.lowest = std::min(0.0, area.ground->heights(area.left(), -area.left()).lowest);
    return area;
}

std::string size_text(const WorldArea& area) {
    return fmt::format("{} m x {} m{}", short_text(area.width), short_text(area.height),
                       area.has_ground ? " above the ground" : "");
}

}  // namespace cambrian
