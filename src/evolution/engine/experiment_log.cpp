#include "evolution/engine/experiment_log.h"

#include "evolution/evaluation/terrain_ladder.h"

#include <algorithm>
#include <iterator>

namespace cambrian {
namespace {

void give(Evolution& evolution, const ChangeSettings& command) {
    evolution.replace_settings(command.settings);
}
void give(Evolution& evolution, const InjectGenome& command) {
    evolution.inject(command.genome);
}
void give(Evolution& evolution, const AddImmigrants& command) {
    evolution.add_immigrants(command.share);
}
void give(Evolution& evolution, const RescorePopulation& /*command*/) {
    evolution.rescore();
}

// Whether a command changes the evaluation of the generation in which it was given.
bool concerns_judgement(const SteeringCommand& command) {
    return std::holds_alternative<ChangeSettings>(command) ||
           std::holds_alternative<RescorePopulation>(command);
}

// Applies the commands of the present generation for which the condition holds.
template <class Condition>
void give_some(Evolution& evolution, const std::vector<NotedCommand>& journal,
               const Condition& holds) {
    const std::uint32_t generation = evolution.generation();
    for (const NotedCommand& noted : journal) {
        if (noted.generation != generation || !holds(noted.command)) continue;
        std::visit([&](const auto& command) { give(evolution, command); }, noted.command);
    }
}

// Applies the commands that concern children; the generation itself is already evaluated.
void give_breeding_commands(Evolution& evolution, const std::vector<NotedCommand>& journal) {
    give_some(evolution, journal,
              [](const SteeringCommand& command) { return !concerns_judgement(command); });
}

}  // namespace

void give_commands(Evolution& evolution, const std::vector<NotedCommand>& journal) {
    give_some(evolution, journal, [](const SteeringCommand& /*command*/) { return true; });
}

namespace {

// Adds the generations in which the run itself changed settings, found in those of the champions.
void add_own_changes(std::vector<JournalEntry>& changes, const SavedExperiment& saved) {
    for (const JudgedIndividual& champion : saved.champions) {
        const auto later = std::find_if(
            changes.begin(), changes.end(),
            [&](const JournalEntry& each) { return each.generation > champion.generation; });
        if (changed_by_run(*std::prev(later)->settings, *champion.settings))
            changes.insert(later, {champion.generation, champion.settings});
    }
}

}  // namespace

std::vector<JournalEntry> setting_changes(const SavedExperiment& saved) {
    std::vector<JournalEntry> changes = {{0, saved.settings}};
    for (const NotedCommand& noted : saved.journal) {
        if (const auto* change = std::get_if<ChangeSettings>(&noted.command))
            changes.push_back({noted.generation, change->settings});
    }
    add_own_changes(changes, saved);
    return changes;
}

Evolution begun_anew(const SavedExperiment& saved, const EvolutionKinds& kinds) {
    Evolution evolution(saved.settings, kinds, saved.founders);
    give_commands(evolution, saved.journal);
    return evolution;
}

Evolution resumed(const SavedExperiment& saved, const EvolutionKinds& kinds) {
    if (!saved.latest) return begun_anew(saved, kinds);
    EvolutionState state = *saved.latest;
    for (const JudgedIndividual& champion : saved.champions) {
        if (champion.generation < state.generation)
            state.champions.push_back(champion.individual->genome);
    }
    state.founders = saved.founders;
    Evolution evolution(std::move(state), kinds);
    give_breeding_commands(evolution, saved.journal);
    evolution.breed();
    give_commands(evolution, saved.journal);
    return evolution;
}

}  // namespace cambrian
