#include "persist/creature/creature_schema.h"

#include "persist/creature/creature_format.h"
#include "persist/json/json_schema_writer.h"

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
    Meaning{"format", "What kind of file this is."},
    Meaning{"version", "Version of the format."},
    Meaning{"name", "What it is called; at most 64 bytes of UTF-8."},
    Meaning{"creature.uid", "Its number, as 16 hexadecimal digits."},
    Meaning{"parents", "Numbers of the creatures it was bred from."},
    Meaning{"method", "How it was bred."},
    Meaning{"ancestry",
            "Digest of its line of descent: numbers, generations, methods and genes of its mothers "
            "back to the first."},
    Meaning{"hue", "Its colour on the colour circle."},
    Meaning{"reproduction", "How it is bred, where the experiment lets creatures choose."},
    Meaning{"rootAngle", "Angle of the first part at birth."},
    Meaning{"nodes", "Part genes; the first is the root."},
    Meaning{"brain", "Central neurons."},
    Meaning{"scored", "The trial that scored it: all that is needed to run it again."},
    Meaning{"check", "Digest of the genes; if it does not match, someone has edited them."},
    Meaning{"node.uid", "Stays the same from parent to offspring."},
    Meaning{"length", "Length of the part."},
    Meaning{"width", "Width of the part."},
    Meaning{"joint", "Joint to the parent; of no effect on the root."},
    Meaning{"limits", "How far the joint goes to either side."},
    Meaning{"recursionLimit", "How often the part may repeat along a limb."},
    Meaning{"symmetric", "Whether two connections from one parent become a mirror pair."},
    Meaning{"mirrorAxis", "Axis of the parent about which the pair is mirrored."},
    Meaning{"effector", "What drives the joint."},
    Meaning{"neurons", "Neurons of the part."},
    Meaning{"edges", "Connections to parts that grow from it."},
    Meaning{"target", "Index of the node that grows there; must be below the number of nodes."},
    Meaning{"pos", "Where on the parent's outline, as a share of its length."},
    Meaning{"angle", "Direction of growth, from the outward normal."},
    Meaning{"scale", "Multiplies the size of all that grows there."},
    Meaning{"reflect", "Flips the handedness of all that grows there."},
    Meaning{"terminalOnly", "Followed only where a repetition has ended."},
    Meaning{"fn", "The neuron's function."},
    Meaning{"in", "The function's inputs, as many as it has."},
    Meaning{"source", "Where the value comes from."},
    Meaning{"from", "Where the value comes from."},
    Meaning{"weight", "Multiplies the value; of a constant, the value itself."},
    Meaning{"w", "Multiplies the value; of a constant, the value itself."},
    Meaning{"effector.kind", "How the joint is driven."},
    Meaning{"kind", "What is read."},
    Meaning{"k", "Index of the neuron, modulo how many there are."},
    Meaning{
        "ch",
        "The sensor channel; in files of version 1 its number. One that does not exist reads 0."},
    Meaning{"e", "Which of the parts that grow from this one."},
    Meaning{"n", "Index of the node whose part is read."},
    Meaning{"i", "Which of the node's parts."},
    Meaning{"goal", "What was asked of it."},
    Meaning{"environment", "The world."},
    Meaning{"simulation", "How motion is computed."},
    Meaning{"trial", "How the trial is run."},
    Meaning{"body", "Limits of what genes grow to."},
    Meaning{"simulator", "Version of the simulator that ran the trial."},
    Meaning{"seed", "Seed of the experiment."},
    Meaning{"scored.fitness", "The score."},
    Meaning{"unit", "Unit of the score."},
    Meaning{"confirmed",
            "Scores in the trial's world and in others a hair different, to tell merit from luck."},
    Meaning{"worlds", "In how many worlds it was tried."},
    Meaning{"median", "The median of the scores."},
    Meaning{"lowest", "The lowest of the scores."},
    Meaning{"highest", "The highest of the scores."},
    Meaning{"trajectory", "Digest of the motion."},
    Meaning{"ticks",
            "A byte for each tick of 1/60 s of the motion, a second a line, as hexadecimal digits: "
            "where a replay differs is told by them."},
    Meaning{"recomputed", "What the trial came to when computed more finely."},
    Meaning{"recomputed.outcome", "How it ended."},
    Meaning{"recomputed.fitness", "The score it came to."},
    Meaning{"verdict", "What the audit of its energy found."},
};

std::string meaning_of(std::string_view type, std::string_view key) {
    const std::string of_type = std::string(type) + "." + std::string(key);
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
    if (writer.has("scored")) {
        writer.object("scored", Layout::kLines, [&](JsonSchemaWriter& inner) {
            describe_scored(inner, document.scored.emplace(), settings, score_tables(kinds));
        });
    }
    if (writer.has("check")) writer.digest("check", 0);
}

}  // namespace

std::string creature_schema(const EvolutionKinds& kinds) {
    JsonSchemaWriter::Library library{.meaning = meaning_of};
    CreatureText document;
    document.genome.nodes.resize(gene_range::kMaxNodes);  // allows every edge target in the schema
    const Json reference = JsonSchemaWriter::object_schema(
        library, [&](JsonSchemaWriter& writer) { describe_creature(writer, document, kinds); });
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"$id", "urn:cambrian:creature:" + std::to_string(kVersion)},
                   {"title", "Cambrian creature"},
                   {"description",
                    "One creature: its genes, where it comes from, and the trial "
                    "that scored it. Unknown keys are ignored."}};
    schema.update(reference);
    schema["$defs"] = std::move(library.definitions);
    return schema.dump(2) + "\n";
}

}  // namespace cambrian
