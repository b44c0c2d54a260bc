#include "preserve/life/founders.h"

#include "evolution/generation.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr std::uint64_t kDrawsOfAFounder = 200;

}  // namespace

Result<std::vector<GenomePtr>> random_founders(const ExperimentSettings& settings,
                                               const EvolutionKinds& kinds) {
    const auto wanted = static_cast<std::size_t>(settings.preserve.founders);
    std::vector<GenomePtr> founders;
    for (std::uint64_t draw = 0; draw < wanted * kDrawsOfAFounder; ++draw) {
        const GenomePtr genome = make_immigrant(settings, kinds, 0, draw)->genome;
        const Phenotype phenotype =
            express(*genome, kinds.creature, settings.expression, settings.world.scene);
        if (!phenotype.can_move() || !phenotype.has_live_control) continue;
        founders.push_back(genome);
        if (founders.size() == wanted) return founders;
    }
    return Error{
        fmt::format("[body]: only {} of {} random creatures can move; expected {} founders that do",
                    founders.size(), wanted * kDrawsOfAFounder, wanted)};
}

}  // namespace cambrian
