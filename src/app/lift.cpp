#include "app/builtin_kinds.h"
#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "evolution/settings/goal_defaults.h"
#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>

namespace cambrian {
namespace {

constexpr const char* kLiftedMethod = "lifted";

bool has_organs(const Genome& genome) {
    return std::any_of(genome.nodes.begin(), genome.nodes.end(),
                       [](const NodeGene& node) { return !node.organs.empty(); });
}

// Returns the creature in space, in the default world of its goal there, without a score. Where
// that goal is not built in space, it is that of swimmers.
CreatureDocument lifted_document(const CreatureDocument& planar, double depth,
                                 const EvolutionKinds& space) {
    Genome genome = lifted(planar.genome(), depth);
    repair(genome, space.creature.catalog);
    Individual individual;
    individual.genome_hash = genome_hash(genome);
    individual.genome = std::make_shared<const Genome>(std::move(genome));
    individual.method = kLiftedMethod;
    const std::string& goal = planar.settings().goal;
    ExperimentSettings settings = default_settings(is_goal_of_space(goal) ? goal : "", space);
    settings.expression = planar.settings().expression;
    settings.expression.strict_overlap = false;
    CreatureDocument document;
    document.creature.individual = std::make_shared<const Individual>(std::move(individual));
    document.creature.settings = std::make_shared<const ExperimentSettings>(std::move(settings));
    return document;
}

class LiftSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("creature", creature_,
                       "Creature file (*.creature.json) or card (*.card.png) of two dimensions")
            ->type_name(option_type::kCreature)
            ->required();
        app.add_option("-o,--out", out_, "Creature file to write")
            ->type_name(option_type::kCreature)
            ->required();
        app.add_option("--depth", depth_,
                       "Depth of every part in meters, 0.08 to 0.96; by default each part is as "
                       "deep as it is wide")
            ->check(CLI::Range(gene_range::kMinSize, gene_range::kMaxWidth));
    }
    CommandFiles files() const override {
        return CommandFiles().reads(creature_).writes(out_, output_form::kCreature);
    }
    ExitStatus run(const EvolutionKinds& kinds) override {
        const Result<CreatureDocument> planar = load_creature(creature_, kinds);
        if (!planar) return fail(planar.error());
        say_of(creature_, planar->warnings);
        if (has_organs(planar->genome()))
            return fail({creature_ + ": has organs, which are not built in three dimensions yet"});
        const auto path = output_path(out_, "", files());
        if (!path) return fail(path.error());
        const EvolutionKinds space = builtin_kinds(3);
        const CreatureDocument document = lifted_document(*planar, depth_.value_or(0.0), space);
        const Status saved = save_creature(*path, document, space);
        return saved ? ExitStatus::kDone : fail(saved.error(), ExitStatus::kFailed);
    }

private:
    std::string creature_;
    std::string out_;
    std::optional<double> depth_;
};

}  // namespace

SubcommandKind lift_subcommand() {
    return {.id = "lift",
            .summary = "Put a creature of two dimensions into three, as a body of boxes.",
            .example = "cambrian lift assets/creatures/dart.creature.json -o dart-3d.creature.json",
            .make = make_subcommand<LiftSubcommand>};
}

}  // namespace cambrian
