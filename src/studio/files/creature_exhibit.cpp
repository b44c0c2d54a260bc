#include "studio/files/creature_exhibit.h"

#include "core/text/pretty_text.h"
#include "persist/text/digest_text.h"

#include <algorithm>
#include <utility>

namespace cambrian {
namespace {

// Restores the individual as far as the file describes it. Of its result, the file has the fitness
// and what replays are compared with.
Individual individual_of(const CreatureDocument& document) {
    Individual individual;
    individual.uid = parse_hex(document.uid).value_or(0);
    individual.genome = std::make_shared<const Genome>(document.genome);
    individual.genome_hash = genome_hash(document.genome);
    const std::size_t parents = std::min(document.parents.size(), individual.parents.size());
    for (std::size_t i = 0; i < parents; ++i)
        individual.parents[i] = parse_hex(document.parents[i]).value_or(0);
    individual.method = document.method;
    individual.evaluated = document.scored.has_value();
    if (!document.scored) return individual;
    individual.result.fitness = document.scored->fitness;
    individual.result.digest = document.scored->trajectory;
    individual.result.finer = document.scored->finer;
    return individual;
}

// Returns the record of a score that was computed from the displayed trial alone.
ScoredRecord scored_on_display(const ExperimentSettings& settings, const ScoreReport& score,
                               const std::string& unit) {
    ScoredRecord scored{.world = settings.world,
                        .expression = settings.expression,
                        .goal = settings.goal,
                        .seed = settings.seed,
                        .fitness = score.score.value,
                        .confirmed = {},
                        .unit = unit,
                        .trajectory = score.record.digest,
                        .finer = {}};
    scored.world.trial.trials = 1;
    return scored;
}

}  // namespace

Exhibit exhibit_of(const CreatureDocument& document, const ExperimentSettings& otherwise,
                   ExhibitSource source, const std::filesystem::path& path) {
    const std::string stem = path.filename().string();
    Exhibit exhibit;
    exhibit.creature.individual = std::make_shared<const Individual>(individual_of(document));
    exhibit.creature.settings = std::make_shared<const ExperimentSettings>(
        document.scored ? settings_of(*document.scored) : otherwise);
    exhibit.source = source;
    exhibit.title = document.genome.name.empty() ? capitalized(stem.substr(0, stem.find('.')))
                                                 : document.genome.name;
    exhibit.ancestry = document.ancestry;
    if (document.scored) exhibit.ticks = document.scored->ticks;
    return exhibit;
}

CreatureDocument document_of(const Exhibit& exhibit, const ScoreReport* score,
                             const EvolutionKinds& kinds) {
    CreatureDocument document = creature_document(exhibit.individual(), exhibit.settings(), kinds);
    document.uid = uid_text(exhibit.individual().uid);
    document.ancestry = exhibit.ancestry;
    const GoalKind* goal = kinds.goals.find(exhibit.settings().goal);
    if (document.scored) {
        document.scored->ticks = exhibit.ticks;
    } else if (goal != nullptr && score != nullptr) {
        document.scored = scored_on_display(exhibit.settings(), *score, goal->unit);
    }
    return document;
}

}  // namespace cambrian
