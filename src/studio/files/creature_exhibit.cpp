#include "studio/files/creature_exhibit.h"

#include "core/text/code_points.h"
#include "core/text/pretty_text.h"

#include <utility>

namespace cambrian {
namespace {

// Returns the creature with a score that was computed from the displayed trial alone.
JudgedIndividual scored_on_display(JudgedIndividual creature, const ScoreReport& score) {
    change_individual(creature, [&](Individual& individual) {
        individual.evaluated = true;
        individual.result = {};
        individual.result.fitness = score.score.value;
        individual.result.digest = score.record.digest;
    });
    change_settings(creature, [](ExperimentSettings& each) { each.world.trial.trials = 1; });
    return creature;
}

}  // namespace

Exhibit exhibit_of(const CreatureDocument& document, const ExperimentSettings& otherwise,
                   ExhibitSource source, const std::filesystem::path& path) {
    const std::string stem = path.filename().string();
    const std::string& name = document.genome().name;
    Exhibit exhibit;
    exhibit.creature = document.creature;
    exhibit.source = source;
    if (!document.scored() && !document.has_world())
        exhibit.creature.settings = std::make_shared<const ExperimentSettings>(otherwise);
    exhibit.title = name.empty() ? capitalized(stem.substr(0, stem.find('.'))) : on_one_line(name);
    exhibit.ancestry = document.ancestry;
    exhibit.ticks = document.notes.ticks;
    return exhibit;
}

CreatureDocument document_of(const Exhibit& exhibit, const ScoreReport* score,
                             const EvolutionKinds& kinds) {
    CreatureDocument document = creature_document(exhibit.creature, kinds);
    document.ancestry = exhibit.ancestry;
    const bool known = kinds.goals.find(exhibit.settings().goal) != nullptr;
    if (document.scored()) {
        document.notes.ticks = exhibit.ticks;
    } else if (known && score != nullptr) {
        document.creature = scored_on_display(std::move(document.creature), *score);
    }
    return document;
}

}  // namespace cambrian
