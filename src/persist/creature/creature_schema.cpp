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
    Meaning{"dimensions", "The dimensions of the space it lives in."},
    Meaning{"name", "The name of the creature; at most 64 bytes of UTF-8."},
    Meaning{"creature.uid", "The number of the creature, as 16 hexadecimal digits."},
    Meaning{"parents", "The numbers of the creatures it was bred from."},
    Meaning{"method", "The method by which it was bred."},
    Meaning{"ancestry",
            "The digest of its line of descent: numbers, generations, methods and genes of its "
            "mothers back to the first."},
    Meaning{"hue", "The creature's hue on the colour circle."},
    Meaning{"world",
            "The world of a creature that was never scored. A creature with a score has the world "
            "in `scored`."},
    Meaning{"scored", "The trial that scored the creature, with all that is needed to repeat it."},
    Meaning{"check", "The digest of the genes. It does not match if they were edited."},
    Meaning{"node.uid", "The number of the gene, which offspring keep."},
    Meaning{"organ.kind", "The kind of the organ."},
    Meaning{"fn", "The neuron's function."},
    Meaning{"in", "The function's inputs, as many as it has."},
    Meaning{"from", "The source of the value."},
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

template <class... Genes>
std::string meaning_among_fields_of(std::string_view key) {
    std::string meaning;
    const auto look = [&](const auto& field) {
        if (field.rule.key == key) meaning = field.rule.help;
    };
    (visit_fields<Genes>(look), ...);
    return meaning;
}

std::string meaning_of(std::string_view type, std::string_view key) {
    const std::string of_type = fmt::format("{}.{}", type, key);
    const auto found = std::find_if(
        kMeanings.begin(), kMeanings.end(),
        [&](const Meaning& meaning) { return meaning.key == key || meaning.key == of_type; });
    if (found != kMeanings.end()) return std::string(found->text);
    std::string meaning = meaning_among_fields_of<Genome, NodeGene, EdgeGene, InputGene>(key);
    CAMBRIAN_ASSERT(!meaning.empty(), "every key has a meaning");
    return meaning;
}

int newest_version(int dimensions) {
    return dimensions == 3 ? kVersionOfSpace : kVersion;
}

void describe_creature(JsonSchemaWriter& writer, CreatureText& document,
                       const EvolutionKinds& kinds) {
    const KindNames names = names_of(kinds.creature.catalog);
    const bool in_space = names.dimensions == 3;
    writer.constant("format", kFormat);
    writer.integer("version", 0, in_space ? kVersionOfSpace : 1, newest_version(names.dimensions));
    if (in_space) writer.integer("dimensions", 3, 3, 3);
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
                   {"$id", fmt::format("urn:cambrian:creature:{}",
                                       newest_version(kinds.creature.catalog.dimensions))},
                   {"title", "Cambrian creature"},
                   {"description",
                    "One creature: its genes, where it comes from, and the trial "
                    "that scored it. Unknown keys are ignored."}};
    schema.update(reference);
    schema["$defs"] = std::move(library.definitions);
    return schema.dump(2) + "\n";
}

}  // namespace cambrian
