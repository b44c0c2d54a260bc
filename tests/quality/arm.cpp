#include "quality/arm.h"

#include "core/assert.h"

#include <algorithm>
#include <iterator>

namespace cambrian::quality {
namespace {

void breed_only(ExperimentSettings& settings, const char* method) {
    settings.population.tuned = 0.0;
    for (const char* other : {"asexual", "crossover", "grafting", "homologous-crossover"})
        settings.breeding.shares[other] = 0.0;
    settings.breeding.shares[method] = 1.0;
}

template <const auto& id>
void select_by(ExperimentSettings& settings) {
    settings.selection.method = id;
}

constexpr char kRank[] = "rank";
constexpr char kTournament[] = "tournament";
constexpr char kRoulette[] = "roulette";
constexpr char kMap[] = "map-elites";
constexpr char kNovelty[] = "novelty";
constexpr char kAge[] = "age-protection";

constexpr Arm kArms[] = {
    {kEvolution, "the usual settings", [](ExperimentSettings& /*settings*/) {}},
    {kRepeated, "the same once more, which must come to the same",
     [](ExperimentSettings& /*settings*/) {}},
    {kRandomSearch, "new random creatures only; the best are kept",
     [](ExperimentSettings& s) { s.population.immigrants = s.population.size; }},
    {kBlind, "a light that cannot be seen",
     [](ExperimentSettings& s) { s.world.environment.light_brightness = 0.0; }},
    {kBreedingArms[0], "all children are mutated copies",
     [](ExperimentSettings& s) { breed_only(s, "asexual"); }},
    {kBreedingArms[1], "all children come from crossover",
     [](ExperimentSettings& s) { breed_only(s, "crossover"); }},
    {kBreedingArms[2], "all children come from grafting",
     [](ExperimentSettings& s) { breed_only(s, "grafting"); }},
    {kNoMutation, "recombination alone",
     [](ExperimentSettings& s) {
         s.mutation.scheme = "none";
         s.population.tuned = 0.0;
         s.breeding.shares = {{"asexual", 0.0}, {"crossover", 0.5}, {"grafting", 0.5}};
     }},
    {kRank, "selection by rank", select_by<kRank>},
    {kTournament, "selection by tournaments of three", select_by<kTournament>},
    {kRoulette, "selection in proportion to fitness", select_by<kRoulette>},
    {kMapElites, "the best of each kind of body", select_by<kMap>},
    {kNovelty, "novelty with local competition", select_by<kNovelty>},
    {kAge, "protection of young bodies", select_by<kAge>},
};

}  // namespace

std::span<const Arm> all_arms() {
    return kArms;
}

const Arm& arm_of(std::string_view id) {
    const auto* const arm = std::find_if(std::begin(kArms), std::end(kArms),
                                         [&](const Arm& candidate) { return candidate.id == id; });
    CAMBRIAN_ASSERT(arm != std::end(kArms), "plans name known arms");
    return *arm;
}

}  // namespace cambrian::quality
