#include "studio/panels/inspector/ancestry.h"

#include <fmt/core.h>

#include <utility>

namespace cambrian {
namespace {

bool judged(const Individual& individual) {
    return individual.evaluated && individual.result.outcome == Outcome::kCompleted;
}

// Returns the settings with which a generation was evaluated; null before the journal begins.
SettingsPtr settings_of_generation(const std::vector<JournalEntry>& journal,
                                   std::uint32_t generation) {
    SettingsPtr settings;
    for (const JournalEntry& entry : journal) {
        if (entry.generation <= generation) settings = entry.settings;
    }
    return settings;
}

}  // namespace

std::vector<AncestryStep> ancestry_of(const Exhibit& exhibit) {
    std::vector<AncestryStep> line;
    for (IndividualPtr one = exhibit.creature.individual; one != nullptr; one = one->mother.get()) {
        AncestryStep step{one, {}};
        const IndividualPtr& mother = one->mother.get();
        if (mother != nullptr && judged(*one) && judged(*mother))
            step.gained = one->result.fitness - mother->result.fitness;
        line.push_back(std::move(step));
    }
    return line;
}

Exhibit ancestor_exhibit(const Exhibit& head, const std::vector<AncestryStep>& line,
                         std::size_t index, const EvolutionSnapshot& snapshot) {
    const IndividualPtr& ancestor = line[index].individual;
    // Parents were last evaluated in the generation before their child's birth. A creature that was
    // edited by hand stays in the world in which it was displayed.
    const Individual& child = *line[index - 1].individual;
    const bool edited = child.method == "edited";
    const std::uint32_t generation = child.born > 0 ? child.born - 1 : 0;
    SettingsPtr settings;
    if (!edited && head.experiment == snapshot.experiment)
        settings = settings_of_generation(snapshot.journal, generation);
    const bool known = settings != nullptr || edited;
    Exhibit exhibit = exhibit_of({.generation = ancestor->born,
                                  .individual = known ? ancestor : without_score(*ancestor),
                                  .settings = settings ? settings : head.creature.settings},
                                 ExhibitSource::kPopulation);
    exhibit.title = fmt::format("Ancestor of generation {}", ancestor->born);
    exhibit.experiment = head.experiment;
    return exhibit;
}

}  // namespace cambrian
