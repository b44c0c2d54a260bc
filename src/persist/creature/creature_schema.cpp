#include "persist/creature/creature_schema.h"

#include "persist/creature/creature_format.h"
#include "persist/json/json_schema_writer.h"

#include <fmt/core.h>

#include <array>

namespace cambrian {
namespace {

using namespace creature_format;
using Json = JsonSchemaWriter::Json;

struct Meaning {
    std::string_view key;  // or "type.key" where the meaning depends on the type
    std::string_view text;
};

constexpr std::array kMeanings = {
    Meaning{"format", "The kind of the file."},
    Meaning{"version", "The version of the format."},
    Meaning{"name", "The name of the creature; at most 64 bytes of UTF-8."},
    Meaning{"creature.uid", "The number of the creature, as 16 hexadecimal digits."},
    Meaning{"parents", "The numbers of the creatures it was bred from."},
    Meaning{"method", "The method by which it was bred."},
    Meaning{"ancestry",
            "The digest of its line of descent: numbers, generations, methods and genes of its "
            "mothers back to the first."},
    Meaning{"hue", "The creature's hue on the colour circle."},
    Meaning{"reproduction",
            "The breeding method of its offspring, if the experiment leaves this to creatures."},
    Meaning{"rootAngle", "The angle of the first part at birth."},
    Meaning{"nodes", "The part genes; the first is the root."},
    Meaning{"brain", "The central neurons."},
    Meaning{"world",
            "The world of a creature that was never scored. A creature with a score has the world "
            "in `scored`."},
    Meaning{"scored", "The trial that scored the creature, with all that is needed to repeat it."},
    Meaning{"check", "The digest of the genes. It does not match if they were edited."},
    Meaning{"node.uid", "The number of the gene, which offspring keep."},
    Meaning{"length", "The length of the part."},
    Meaning{"width", "The width of the part."},
    Meaning{"joint", "The joint to the parent; of no effect on the root."},
    Meaning{"limits", "The limits of the joint on either side."},
    Meaning{"recursionLimit", "The number of times that the part may repeat along a limb."},
    Meaning{"symmetric", "Two connections from one parent become a mirror pair if this is true."},
    Meaning{"mirrorAxis", "The axis of the parent about which the pair is mirrored."},
    Meaning{"effector", "The effector that drives the joint."},
    Meaning{"organs", "The organs of the part; they exist since version 3."},
    Meaning{"organ.kind", "The kind of the organ."},
    Meaning{"neurons", "The neurons of the part."},
    Meaning{"edges", "The connections to parts that grow from this one."},
    Meaning{"target",
            "The index of the node that grows there; it must be below the number of nodes."},
    Meaning{"pos", "The position on the parent's outline, as a share of its length."},
    Meaning{"angle", "The direction of growth, from the outward normal."},
    Meaning{"scale", "The factor of the size of all that grows there."},
    Meaning{"reflect", "The handedness of all that grows there is flipped if this is true."},
    Meaning{"terminalOnly",
            "The connection is followed only at the end of a repetition if this is true."},
    Meaning{"fn", "The neuron's function."},
    Meaning{"in", "The function's inputs, as many as it has."},
    Meaning{"source", "The source of the value."},
    Meaning{"from", "The source of the value."},
    Meaning{"weight", "The factor of the value; for a constant, the value itself."},
    Meaning{"w", "The factor of the value; for a constant, the value itself."},
    Meaning{"effector.kind", "The kind of the effector."},
    Meaning{"kind", "The kind of the source."},
    Meaning{"k", "The index of the neuron, modulo their number."},
    Meaning{
        "ch",
        "The sensor channel; in files of version 1 its number. One that does not exist reads 0."},
    Meaning{"e", "The index of the connection to the part that is read."},
    Meaning{"n", "The index of the node whose part is read."},
    Meaning{"i", "The index among the node's parts."},
    Meaning{"goal", "The goal of the trial."},
    Meaning{"environment", "The world of the trial."},
    Meaning{"simulation", "The settings of the simulation."},
    Meaning{"trial", "The settings of the trial."},
    Meaning{"body", "The limits of the body that grows from the genes."},
    Meaning{"simulator", "The version of the simulator that ran the trial."},
    Meaning{"seed", "The seed of the experiment."},
    Meaning{"scored.fitness", "The score."},
    Meaning{"unit", "The unit of the score."},
    Meaning{"confirmed",
            "The scores in the trial's world and in slightly different ones, which separate merit "
            "from luck."},
    Meaning{"worlds", "The number of these worlds."},
    Meaning{"median", "The median of the scores."},
    Meaning{"lowest", "The lowest of the scores."},
    Meaning{"highest", "The highest of the scores."},
    Meaning{"trajectory", "The digest of the motion."},
    Meaning{"ticks",
            "The check bytes of the motion, one for each tick of 1/60 s, a second a line, as "
            "hexadecimal digits. They tell where a replay differs."},
    Meaning{"recomputed", "The result of the trial when it was computed more finely."},
    Meaning{"recomputed.outcome", "The outcome of that trial."},
    Meaning{"recomputed.fitness", "The score of that trial."},
    Meaning{"opponents",
            "The creatures it contended with, one for each trial, each with all of its genes."},
    Meaning{"verdict", "The verdict of the energy audit."},
};

std::string meaning_of(std::string_view type, std::string_view key) {
    const std::string of_type = fmt::format("{}.{}", type, key);
    const auto found = std::find_if(
        kMeanings.begin(), kMeanings.end(),
        [&](const Meaning& meaning) { return meaning.key == key || meaning.key == of_type; });
    CAMBRIAN_ASSERT(found != kMeanings.end(), "every key has a meaning");
    return std::string(found->text);
}

void describe_creature(JsonSchemaWriter& writer, CreatureText& document,
                       const EvolutionKinds& kinds) {
    writer.constant("format", kFormat);
    writer.integer("version", kVersion, 1, kVersion);
    const KindNames names = names_of(kinds.creature.catalog);
    describe_identity(writer, document, names);
    describe_genes(writer, document.genome, names);
    ExperimentSettings settings;
    if (writer.has("world")) {
        writer.object("world", JsonLayout::kLines, [&](JsonSchemaWriter& inner) {
            describe_world(inner, document.opponents, settings, score_tables(kinds), names);
        });
    }
    if (writer.has("scored")) {
        writer.object("scored", JsonLayout::kLines, [&](JsonSchemaWriter& inner) {
            describe_scored(inner, document.scored.emplace(), document.opponents, settings,
                            score_tables(kinds), names);
        });
    }
    if (writer.has("check")) writer.digest("check", 0);
}

}  // namespace

std::string creature_schema(const EvolutionKinds& kinds) {
    JsonSchemaWriter::Library library{.meaning = meaning_of};
    CreatureText document;
    const Json reference = JsonSchemaWriter::object_schema(
        library, [&](JsonSchemaWriter& writer) { describe_creature(writer, document, kinds); });
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"$id", fmt::format("urn:cambrian:creature:{}", kVersion)},
                   {"title", "Cambrian creature"},
                   {"description",
                    "One creature: its genes, where it comes from, and the trial "
                    "that scored it. Unknown keys are ignored."}};
    schema.update(reference);
    schema["$defs"] = std::move(library.definitions);
    return schema.dump(2) + "\n";
}

}  // namespace cambrian
