#include "studio/playback/exhibit.h"

#include "core/pretty_text.h"
#include "evolution/ancestry_digest.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace cambrian {

std::string uid_text(std::uint64_t uid) {
    return uid == 0 ? std::string() : format("%016llx", static_cast<unsigned long long>(uid));
}

std::string goal_unit(const std::string& goal, const GoalRegistry& goals) {
    const GoalKind* kind = goals.find(goal);
    return kind == nullptr ? std::string() : kind->unit;
}

std::uint64_t uid_of(const std::string& text) {
    std::uint64_t uid = 0;
    const char* end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, uid, 16);
    return parsed.ec == std::errc() && parsed.ptr == end ? uid : 0;
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
    exhibit.born = individual.born;
    exhibit.mother = individual.mother;
    exhibit.uid = uid_text(individual.uid);
    exhibit.method = individual.method;
    for (const std::uint64_t parent : individual.parents) {
        if (parent != 0) exhibit.parents.push_back(uid_text(parent));
    }
    exhibit.mutations = individual.mutations;
    exhibit.ancestry = ancestry_digest(individual);
    if (individual.evaluated) exhibit.result = individual.result;
    return exhibit;
}

IndividualPtr individual_of(const Exhibit& exhibit) {
    Individual individual;
    individual.uid = uid_of(exhibit.uid);
    individual.born = exhibit.born;
    individual.genome = exhibit.genome;
    individual.genome_hash = genome_hash(*exhibit.genome);
    for (std::size_t i = 0; i < std::min(exhibit.parents.size(), individual.parents.size()); ++i)
        individual.parents[i] = uid_of(exhibit.parents[i]);
    individual.mother = exhibit.mother;
    individual.method = exhibit.method;
    individual.mutations = exhibit.mutations;
    individual.evaluated = exhibit.result.has_value();
    if (exhibit.result) individual.result = *exhibit.result;
    return std::make_shared<const Individual>(std::move(individual));
}

}  // namespace cambrian
