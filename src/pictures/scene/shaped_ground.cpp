#include "pictures/scene/shaped_ground.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace cambrian {
namespace {

// Returns the ground that settings describe, or null if it is flat. The last ones are kept, since
// frame after frame shows the same.
std::shared_ptr<const Terrain> ground_in(const TerrainSettings& settings) {
    using Kept = std::pair<TerrainSettings, std::shared_ptr<const Terrain>>;
    constexpr std::size_t kMostKept = 4;
    thread_local std::vector<Kept> last;
    const auto found = std::find_if(last.begin(), last.end(),
                                    [&](const Kept& kept) { return kept.first == settings; });
    if (found != last.end()) return found->second;
    const auto made = Terrain::make(settings);
    if (last.size() == kMostKept) last.erase(last.begin());
    last.emplace_back(settings, made ? *made : nullptr);
    return last.back().second;
}

double level_around(const Terrain& ground, double x) {
    constexpr int kPlaces = 12;      // to either side
    constexpr double kApart = 0.25;  // m
    double sum = 0.0;
    double weights = 0.0;
    for (int i = -kPlaces; i <= kPlaces; ++i) {
        const double weight = 1.0 + kPlaces - std::abs(i);
        sum += weight * ground.height(x + kApart * i);
        weights += weight;
    }
    return sum / weights;
}

}  // namespace

double land_level(const Environment& environment, double x) {
    const auto terrain = ground_in(environment.terrain);
    return terrain ? level_around(*terrain, x) : 0.0;
}

double ground_height(const Environment& environment, double x) {
    const auto terrain = ground_in(environment.terrain);
    return terrain ? terrain->height(x) : 0.0;
}

void use_ground(SceneFrame& frame, const Environment& environment, const Camera& camera,
                const Viewport& viewport) {
    const bool is_shaped = environment.has_ground && !environment.terrain.is_flat();
    use_ground(frame, is_shaped ? ground_in(environment.terrain).get() : nullptr, camera, viewport);
}

void use_ground(SceneFrame& frame, const Terrain* ground, const Camera& camera,
                const Viewport& viewport) {
    frame.ground = {};
    if (ground == nullptr) return;
    constexpr double kBeyond = 1.0;  // m
    const WorldWindow window = camera.window(viewport);
    std::vector<GroundPoint> points;
    ground->list_points(window.low.x() - kBeyond, window.high.x() + kBeyond, points);
    for (const GroundPoint& point : points)
        frame.ground.surface.emplace_back(point.x, point.y);
    frame.ground.level = level_around(*ground, camera.center.x());
}

}  // namespace cambrian
