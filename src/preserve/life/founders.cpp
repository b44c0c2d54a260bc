#include "preserve/life/founders.h"

#include "evolution/generation.h"
#include "preserve/life/resident.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr std::uint64_t kDrawsOfAFounder = 200;

bool can_live(const Genome& genome, const ExperimentSettings& settings, const Kinds& kinds) {
    const Phenotype body = express(genome, kinds, settings.expression, settings.world.scene);
    return body.can_move() && body.has_live_control && scene_of(body, kinds, settings);
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
