#include "studio/files/creature_exhibit.h"

#include "core/pretty_text.h"

#include <utility>

namespace cambrian {

Exhibit exhibit_of(const CreatureDocument& document, const ExperimentSettings& otherwise,
                   ExhibitSource source, const std::filesystem::path& path) {
    const ExperimentSettings settings = document.scored ? settings_of(*document.scored) : otherwise;
    Exhibit exhibit;
    exhibit.genome = std::make_shared<const Genome>(document.genome);
    exhibit.world = settings.world;
    exhibit.goal = settings.goal;
    exhibit.expression = settings.expression;
    exhibit.source = source;
    const std::string stem = path.filename().string();
    exhibit.title = capitalized(stem.substr(0, stem.find('.')));
    if (!document.genome.name.empty()) exhibit.title = document.genome.name;
    exhibit.seed = settings.seed;
    exhibit.uid = document.uid;
    exhibit.method = document.method;
    exhibit.parents = document.parents;
    exhibit.ancestry = document.ancestry;
    if (document.scored) {
        exhibit.ticks = document.scored->ticks;
        EvaluationResult result;
        result.fitness = document.scored->fitness;
        result.digest = document.scored->trajectory;
        result.finer = document.scored->finer;
        exhibit.result = result;
    }
    return exhibit;
}

CreatureDocument document_of(const Exhibit& exhibit, const ScoreReport* score,
                             const GoalRegistry& goals) {
    CreatureDocument document;
    document.genome = *exhibit.genome;
    document.uid = exhibit.uid;
    document.parents = exhibit.parents;
    document.method = exhibit.method;
    document.ancestry = exhibit.ancestry;
    const GoalKind* goal = goals.find(exhibit.goal);
    // A trial that was stopped early gives no score; the one on display is run to its end.
    const bool judged = exhibit.result && exhibit.result->outcome != Outcome::kStoppedEarly;
    if (goal == nullptr || (!judged && score == nullptr)) return document;
    ScoredRecord scored;
    scored.world = exhibit.world;
    if (!judged) scored.world.trial.trials = 1;  // the one on display
    scored.expression = exhibit.expression;
    scored.goal = exhibit.goal;
    scored.seed = exhibit.seed;
    scored.fitness = judged ? exhibit.result->fitness : score->score.value;
    scored.unit = goal->unit;
    scored.trajectory = judged ? exhibit.result->digest : score->record.digest;
    if (judged) {
        scored.finer = exhibit.result->finer;
        scored.ticks = exhibit.ticks;
    }
    document.scored = std::move(scored);
    return document;
}

}  // namespace cambrian
