#include "persist/page/described_creature.h"

#include "core/text/number_text.h"
#include "evolution/evaluation/trials.h"
#include "persist/json/json_text.h"
#include "persist/text/quoted_text.h"
#include "world/terrain.h"

#include <algorithm>

namespace cambrian {
namespace {

std::string described_part(const Phenotype& phenotype, std::size_t part, const Kinds& kinds) {
    const PlannedPart& planned = phenotype.plan.parts[part];
    const BodyPart& grown = phenotype.parts[part];
    const auto sees = [&](const WiredSensor& wired) {
        return wired.part == part && kinds.sensors.all()[wired.kind].sees;
    };
    std::vector<std::string> half;
    for (const double extent : planned.half_extents)
        half.push_back(real_text(extent));
    return json_object(
        {{"parent", std::to_string(planned.parent)},
         {"node", std::to_string(grown.node)},
         {"depth", std::to_string(grown.depth)},
         {"mirrored", json_truth(grown.mirror.across < 0)},
         {"eye", json_truth(std::any_of(phenotype.sensors.begin(), phenotype.sensors.end(), sees))},
         {"half", json_list(half)}});
}

// The points of ground with a shape, around the start; none where it is flat.
std::string surface_of(const ExperimentSettings& settings) {
    constexpr double far = 100.0;  // m
    const TrialWorld world = with_drawn_ground(first_trial_world(settings));
    const auto terrain = Terrain::make(world.environment.terrain);
    std::vector<GroundPoint> points;
    if (terrain && *terrain != nullptr) (*terrain)->list_points(-far, far, points);
    std::vector<std::string> places;
    for (const GroundPoint& point : points)
        places.push_back(json_list({short_text(point.x), short_text(point.y)}));
    return json_list(places);
}

}  // namespace

std::string described_creature(const CreatureDocument& document, const Phenotype& phenotype,
                               const EvolutionKinds& kinds) {
    const ExperimentSettings& settings = document.settings();
    const Environment& world = settings.world.environment;
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < phenotype.parts.size(); ++i)
        parts.push_back(described_part(phenotype, i, kinds.creature));
    return json_object({{"dimensions", std::to_string(world.dimensions)},
                        {"goal", quoted_text(settings.goal)},
                        {"duration", real_text(settings.world.trial.duration)},
                        {"hue", real_text(document.genome().hue)},
                        {"ground", json_truth(world.has_ground)},
                        {"surface", surface_of(settings)},
                        {"gravity", real_text(world.gravity)},
                        {"friction", real_text(world.friction)},
                        {"medium", real_text(world.viscosity_linear + world.viscosity_quadratic)},
                        {"light", json_truth(world.has_light)},
                        {"neurons", std::to_string(phenotype.network.order.size())},
                        {"parts", json_list(parts)}});
}

}  // namespace cambrian
