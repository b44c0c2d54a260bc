#include "studio/exhibit.h"

#include "studio/text.h"

namespace cambrian {

std::string uid_text(std::uint64_t uid) {
    return uid == 0 ? std::string() : format("%016llx", static_cast<unsigned long long>(uid));
}

std::string goal_unit(const std::string& goal, const GoalRegistry& goals) {
    const GoalKind* kind = goals.find(goal);
    return kind == nullptr ? std::string() : kind->unit;
}

Exhibit exhibit_of(const Individual& individual, const ExperimentSettings& settings,
                   std::uint32_t generation, ExhibitSource source) {
    Exhibit exhibit;
    exhibit.genome = individual.genome;
    exhibit.world = settings.world;
    exhibit.goal = settings.goal;
    exhibit.expression = settings.expression;
    exhibit.source = source;
    exhibit.title = source == ExhibitSource::kChampion
                        ? "Champion of generation " + std::to_string(generation)
                        : "Creature of generation " + std::to_string(generation);
    exhibit.seed = settings.seed;
    exhibit.generation = generation;
    exhibit.uid = uid_text(individual.uid);
    exhibit.method = individual.method;
    for (const std::uint64_t parent : individual.parents) {
        if (parent != 0) exhibit.parents.push_back(uid_text(parent));
    }
    exhibit.mutations = individual.mutations;
    if (individual.evaluated) exhibit.result = individual.result;
    return exhibit;
}

}  // namespace cambrian
