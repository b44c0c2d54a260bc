// Fuzzes creature files of the plane and of space: the reader gives a valid genome or a message. A
// loaded creature is written and read again without change, is expressed, and moves for a tenth of
// a second within the limit of work.

#include "fuzz/fuzz_target.h"
#include "persist/creature/creature_file.h"
#include "simulator/trial.h"
#include "support/kinds.h"

#include <algorithm>

using namespace cambrian;
using namespace cambrian::test;

namespace {

constexpr double kDuration = 0.1;         // s
constexpr double kMostEvaluations = 2e3;  // per simulated second

void read_again(const CreatureDocument& document, const EvolutionKinds& all) {
    const std::string text = write_creature(document, all);
    const auto again = parse_creature(text, "again", all);
    promise(again.has_value(), "what is written can be read");
    promise(again->genome() == document.genome(), "a genome is read as it was written");
    promise(same_score(*again, document), "a score is read as it was written");
    promise(write_creature(*again, all) == text, "writing again gives the same bytes");
}

TrialWorld brief(TrialWorld world) {
    world.trial.duration = std::min(world.trial.duration, kDuration);
    world.trial.settle_limit = std::min(world.trial.settle_limit, kDuration);
    world.scene.max_evaluations = std::min(world.scene.max_evaluations, kMostEvaluations);
    return world;
}

void live(const CreatureDocument& document, const Kinds& creature) {
    const ExpressionSettings& expression = document.settings().expression;
    const TrialWorld world = brief(document.settings().world);
    const auto phenotype = std::make_shared<const Phenotype>(
        express(document.genome(), creature, expression, world.scene));
    const std::size_t parts = phenotype->plan.parts.size();
    promise(parts >= 1 && parts <= static_cast<std::size_t>(expression.max_parts),
            "a body keeps to its limit of parts");
    const auto record = run_trial(phenotype, creature, world);
    promise(record.has_value() || !record.error().message.empty(),
            "a body that physics refuses comes with a reason");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(text_of(data, size));
    const EvolutionKinds& all = dimensions_of_creature(text) == 3 ? spatial_kinds() : kinds();
    const auto document = parse_creature(text, "input", all);
    if (!document) {
        promise(document.error().message.starts_with("input: E"), "a refusal has a code");
        return 0;
    }
    promise(validate(document->genome(), all.creature.catalog).empty(), "what is loaded is valid");
    read_again(*document, all);
    live(*document, all.creature);
    return 0;
}
