#include "preserve/life/founders.h"

#include "creature/overlap.h"
#include "evolution/generation.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr std::uint64_t kDrawsOfAFounder = 200;

bool can_live(const Genome& genome, const ExperimentSettings& settings, const Kinds& kinds) {
    const SceneSettings& scene = settings.world.scene;
    const Phenotype phenotype = express(genome, kinds, settings.expression, scene);
    if (!phenotype.can_move() || !phenotype.has_live_control) return false;
    if (settings.expression.strict_overlap && overlaps_itself(phenotype.plan)) return false;
    return kinds.scene.make(phenotype.plan, settings.world.environment, scene).has_value();
}

}  // namespace

Result<std::vector<GenomePtr>> random_founders(const ExperimentSettings& settings,
                                               const EvolutionKinds& kinds) {
    const auto wanted = static_cast<std::size_t>(settings.preserve.founders);
    std::vector<GenomePtr> founders;
    for (std::uint64_t draw = 0; draw < wanted * kDrawsOfAFounder; ++draw) {
        const GenomePtr genome = make_immigrant(settings, kinds, 0, draw)->genome;
        if (!can_live(*genome, settings, kinds.creature)) continue;
        founders.push_back(genome);
        if (founders.size() == wanted) return founders;
    }
    return Error{
        fmt::format("[body]: only {} of {} random creatures can live and move; expected {} "
                    "founders that do",
                    founders.size(), wanted * kDrawsOfAFounder, wanted)};
}

}  // namespace cambrian
