#pragma once

// The format of creature files (persist/README.md 1), described once. The same calls read it with a
// JsonReader, write it with a JsonWriter and write its schema with a JsonSchemaWriter. Objects are
// const when writing.

#include "core/text/counted.h"
#include "genome/gene_fields.h"
#include "genome/source_rules.h"
#include "persist/creature/creature_file.h"
#include "persist/json/json_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

namespace cambrian::creature_format {

inline const std::string kFormat = "cambrian-creature";
// Version 1 has numbers for sensor channels, version 2 names, version 3 organs. Creatures without
// organs are written as version 2. Version 4 is that of creatures in space.
inline constexpr int kVersion = 3;
inline constexpr int kVersionWithoutOrgans = 2;
inline constexpr int kVersionOfSpace = 4;
inline constexpr std::size_t kMaxUid = 32;
inline constexpr std::size_t kMaxWord = 64;
inline constexpr double kMostWorlds = 100.0;
inline constexpr double kMaxSeed = 9007199254740992.0;  // 2^53; whole numbers are exact below

// Ids of the kinds of source, in the order of SourceKind.
inline const std::vector<std::string> kSources = [] {
    std::vector<std::string> ids;
    for (const SourceRule& rule : source_rules())
        ids.emplace_back(rule.id);
    return ids;
}();
inline const std::vector<std::string> kMirrorAxes = {"along", "across"};
inline const std::vector<std::string> kMirrorAxesOfSpace = {"along", "across", "depth"};

// The names of an enumeration's values up to the last one that files may have.
template <class Choice>
std::vector<std::string> names_to(Choice last, std::string_view (*name_of)(Choice)) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i <= static_cast<std::size_t>(last); ++i)
        names.emplace_back(name_of(static_cast<Choice>(i)));
    return names;
}
inline const std::vector<std::string> kOutcomes = names_to(Outcome::kOverBudget, outcome_name);
inline const std::vector<std::string> kVerdicts = names_to(AuditVerdict::kInvalid, verdict_name);

// The ids of the kinds; genes have indices into these lists.
struct KindNames {
    int dimensions = 2;
    std::vector<std::string> functions;
    std::vector<std::string> joints;
    std::vector<std::string> effectors;
    std::vector<int> arities;  // one per function
    NumberedNames channels;
    std::vector<std::string> organs;
    std::vector<std::vector<FieldRule>> parameters;  // those of each kind of organ
    std::vector<bool> single;                        // of which organs a part has at most one
    std::vector<std::string> reproductions;
};

KindNames names_of(const KindCatalog& catalog);

// The values of a file's table "scored", without its settings and opponents.
struct ScoreText {
    std::string simulator{kSimulatorVersion};
    std::uint64_t seed = 0;
    double fitness = 0.0;
    std::string unit;
    std::optional<ConfirmedScore> confirmed;
    std::uint64_t trajectory = 0;
    TickChecks ticks = {};
    std::optional<FinerResult> finer;
};

// The values of a creature file before they become an individual.
struct CreatureText {
    Genome genome;
    std::string uid;
    std::vector<std::string> parents;
    std::string method;
    std::optional<std::uint64_t> ancestry;
    std::optional<ScoreText> scored;
    std::vector<Genome> opponents;  // of the trial that scored it or, without a score, of its world
    std::uint64_t check = 0;
};

// The archive writes or reads the fields a source of that kind has.
template <class Archive, class Source>
void describe_source(Archive& archive, Source& source, SourceScope scope, const KindNames& names) {
    archive.type(scope == SourceScope::kPart ? "partSource" : "centralSource");
    if (!archive.variant("kind", source.kind, kSources, "source")) return;
    archive.require(is_allowed(source.kind, scope), "E12", "kind", [&] {
        return fmt::format("\"{}\" is only for {} neurons",
                           kSources[static_cast<std::size_t>(source.kind)],
                           scope == SourceScope::kPart ? "central" : "part");
    });
    const SourceRule rule = source_rule(source.kind);
    if (rule.uses_child) archive.integer("e", source.child, 0, gene_range::kMaxReference);
    if (rule.uses_instance) {
        archive.integer("n", source.node, 0, gene_range::kMaxReference);
        archive.integer("i", source.instance, 0, gene_range::kMaxReference);
    }
    if (rule.reads == SourceReads::kNeuron)
        archive.integer("k", source.index, 0, gene_range::kMaxReference);
    if (rule.reads == SourceReads::kSensor)
        archive.named_or_numbered("ch", source.index, names.channels, "sensor channel");
}

// Effectors have the keys "source" and "weight", inputs of neurons "from" and "w".
template <class Archive, class Input>
void describe_input(Archive& archive, Input& input, SourceScope scope, const char* source_key,
                    const char* weight_key, const KindNames& names) {
    archive.object(source_key, JsonLayout::kCompact,
                   [&](Archive& inner) { describe_source(inner, input.source, scope, names); });
    archive.real(weight_key, input.weight, input_fields().front().rule);
}

template <class Archive, class Neuron>
void describe_neuron(Archive& archive, Neuron& neuron, SourceScope scope, const KindNames& names) {
    const bool part = scope == SourceScope::kPart;
    archive.type(part ? "partNeuron" : "centralNeuron");
    const bool known = archive.variant("fn", neuron.function, names.functions, "function");
    archive.list("in", neuron.inputs, 0, gene_range::kMaxArity, JsonLayout::kCompact,
                 [&](Archive& inner, auto& input) {
                     inner.type(part ? "partInput" : "centralInput");
                     describe_input(inner, input, scope, "from", "w", names);
                 });
    if (!known) return;
    const auto arity = static_cast<std::size_t>(names.arities[neuron.function]);
    archive.require_count("in", neuron.inputs.size(), arity, "E11", [&] {
        return fmt::format("function \"{}\" needs {}, found {}", names.functions[neuron.function],
                           counted(arity, "input"), neuron.inputs.size());
    });
}

template <class Archive, class Neurons>
void describe_neurons(Archive& archive, const char* key, Neurons& neurons, SourceScope scope,
                      const KindNames& names) {
    const std::size_t most =
        scope == SourceScope::kPart ? gene_range::kMaxNodeNeurons : gene_range::kMaxBrainNeurons;
    archive.list(key, neurons, 0, most, JsonLayout::kLines, [&](Archive& inner, auto& neuron) {
        describe_neuron(inner, neuron, scope, names);
    });
}

template <class Archive, class Organ>
void describe_organ(Archive& archive, Organ& organ, const KindNames& names) {
    archive.type("organ");
    if (!archive.variant("kind", organ.kind, names.organs, "organ")) return;
    describe_input(archive, organ.input, SourceScope::kPart, "source", "weight", names);
    const std::vector<FieldRule>& rules = names.parameters[organ.kind];
    for (std::size_t i = 0; i < rules.size(); ++i)
        archive.real(rules[i].key, organ.parameters[i], rules[i]);
}

template <class Archive, class Organs>
void describe_organs(Archive& archive, Organs& organs, const KindNames& names) {
    archive.optional_list(
        "organs", organs, gene_range::kMaxOrgans, JsonLayout::kCompact,
        [&](Archive& inner, auto& organ) { describe_organ(inner, organ, names); });
    for (std::size_t i = 1; i < organs.size(); ++i) {
        const std::uint8_t kind = organs[i].kind;
        const bool doubled =
            names.single.at(kind) &&
            std::any_of(organs.begin(), organs.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const OrganGene& organ) { return organ.kind == kind; });
        archive.require(!doubled, "E10", "organs", [&] {
            return fmt::format("over 1 entry \"{}\", limit 1", names.organs[kind]);
        });
    }
}

template <class Archive, class Gene>
void describe_effector(Archive& archive, Gene& gene, const KindNames& names) {
    archive.object("effector", JsonLayout::kCompact, [&](Archive& inner) {
        inner.type("furtherEffector");
        if constexpr (requires { gene.effector_kind; }) {
            inner.type("effector");
            inner.optional_choice("kind", gene.effector_kind, names.effectors, "effector");
        }
        describe_input(inner, gene.effector, SourceScope::kPart, "source", "weight", names);
    });
}

template <class Archive, class Gene, class Number>
void describe_number(Archive& archive, Gene& gene, Number& number, const FieldRule& rule) {
    if constexpr (requires { gene.limit_low; }) {  // one list has both limits
        if (&number == &gene.limit_low) return;
        if (&number == &gene.limit_high)
            return archive.pair("limits", gene.limit_low, gene_tables::kLowLimit, number,
                                gene_tables::kHighLimit);
    }
    archive.real(rule.key, number, rule);
}

template <class Archive, class Gene>
void describe_fields(Archive& archive, Gene& gene, std::size_t node_count, const KindNames& names);

// Describes the edges of a node, or its further degrees of freedom.
template <class Archive, class Genes>
void describe_inner(Archive& archive, const char* key, Genes& genes, std::size_t node_count,
                    const KindNames& names) {
    constexpr bool kEdges = std::is_same_v<std::remove_const_t<Genes>, std::vector<EdgeGene>>;
    const auto describe = [&](Archive& inner, auto& item) {
        inner.type(kEdges ? "edge" : "degree");
        describe_fields(inner, item, node_count, names);
    };
    if (kEdges)
        archive.list(key, genes, 0, gene_range::kMaxEdges, JsonLayout::kCompact, describe);
    else
        archive.optional_list(key, genes, kMostDegrees - 1, JsonLayout::kCompact, describe);
}

// Describes the fields of a node, of an edge or of a degree of freedom by the types of their
// values.
template <class Archive, class Gene>
void describe_fields(Archive& archive, Gene& gene, std::size_t node_count, const KindNames& names) {
    visit_fields<std::remove_const_t<Gene>>([&](const auto& field) {
        if (!field.is_of(names.dimensions)) return;
        auto& value = gene.*field.value;
        using Value = std::remove_cvref_t<decltype(value)>;
        const FieldRule& rule = field.rule;
        const char* key = rule.key;
        if constexpr (std::is_same_v<Value, double>) {
            describe_number(archive, gene, value, rule);
        } else if constexpr (std::is_same_v<Value, bool>) {
            archive.flag(key, value);
        } else if constexpr (std::is_same_v<Value, int>) {
            archive.integer(key, value, rule.low, rule.high);
        } else if constexpr (std::is_same_v<Value, MirrorAxis>) {
            const auto& axes = names.dimensions == 3 ? kMirrorAxesOfSpace : kMirrorAxes;
            archive.choice(key, value, axes, "axis");
        } else if constexpr (requires {
                                 gene.target;
                                 value + 1;
                             }) {
            archive.index(key, value, node_count, node_count == 1 ? "node" : "nodes");
        } else if constexpr (std::is_same_v<Value, std::uint8_t>) {
            if (!field.later) archive.choice(key, value, names.joints, "joint");
        } else if constexpr (std::is_same_v<Value, InputGene>) {
            describe_effector(archive, gene, names);
        } else if constexpr (std::is_same_v<Value, std::vector<OrganGene>>) {
            describe_organs(archive, value, names);
        } else if constexpr (std::is_same_v<Value, std::vector<NeuronGene>>) {
            describe_neurons(archive, key, value, SourceScope::kPart, names);
        } else {
            describe_inner(archive, key, value, node_count, names);
        }
    });
}

template <class Archive, class Genes>
void describe_genes(Archive& archive, Genes& genome, const KindNames& names) {
    archive.list("nodes", genome.nodes, 1, gene_range::kMaxNodes, JsonLayout::kLines,
                 [&](Archive& inner, auto& node) {
                     // A schema, which has no nodes, allows every edge target.
                     const std::size_t count = genome.nodes.empty()
                                                   ? std::size_t{gene_range::kMaxNodes}
                                                   : genome.nodes.size();
                     inner.type("node");
                     if (inner.has("uid")) inner.integer("uid", node.uid, 0, 4294967295.0);
                     describe_fields(inner, node, count, names);
                 });
    describe_neurons(archive, "brain", genome.brain, SourceScope::kBrain, names);
}

// The oldest version of the format that has all genes of a genome.
inline int version_of(const Genome& genome) {
    if (genome.dimensions == 3) return kVersionOfSpace;
    const bool organs = std::any_of(genome.nodes.begin(), genome.nodes.end(),
                                    [](const NodeGene& node) { return !node.organs.empty(); });
    return organs ? kVersion : kVersionWithoutOrgans;
}

template <class Archive>
void begin_document(Archive& archive, const Genome& genome) {
    archive.text("format", kFormat, kMaxWord);
    archive.integer("version", version_of(genome), 1, kVersionOfSpace);
    if (genome.dimensions == 3) archive.integer("dimensions", genome.dimensions, 3, 3);
}

inline constexpr FieldRule kHue{
    .name = "hue", .key = "hue", .low = 0.0, .high = 1.0, .fallback = 0.0, .wraps = true};

// The genes that belong to no part.
template <class Archive, class Genes>
void describe_traits(Archive& archive, Genes& genome, const KindNames& names) {
    if (archive.has("hue")) archive.real("hue", genome.hue, kHue);
    if (archive.has("reproduction"))
        archive.choice("reproduction", genome.reproduction, names.reproductions, "breeding method");
    for (const GeneField<Genome>& field : genome_fields(names.dimensions)) {
        if (archive.has(field.rule.key))
            archive.real(field.rule.key, genome.*field.value, field.rule);
    }
}

template <class Archive, class Document>
void describe_identity(Archive& archive, Document& document, const KindNames& names) {
    archive.type("creature");
    auto& genome = document.genome;
    if (archive.has("name")) archive.text("name", genome.name, gene_range::kMaxName);
    if (archive.has("uid")) archive.text("uid", document.uid, kMaxUid);
    if (archive.has("parents")) archive.texts("parents", document.parents, 2, kMaxUid);
    if (archive.has("method")) archive.text("method", document.method, kMaxWord);
    archive.optional_digest("ancestry", document.ancestry);
    describe_traits(archive, genome, names);
}

template <class Archive, class Genes>
void describe_opponent(Archive& archive, Genes& genome, const KindNames& names) {
    archive.type("opponent");
    if (archive.has("name")) archive.text("name", genome.name, gene_range::kMaxName);
    describe_traits(archive, genome, names);
    describe_genes(archive, genome, names);
}

// The settings a score depends on, in the tables they have in settings files.
struct ScoreTable {
    std::string name;
    std::vector<SettingField> fields;
};
std::vector<ScoreTable> score_tables(const EvolutionKinds& kinds);

inline constexpr std::size_t kMostOpponents = 50;  // as many as there may be trials

template <class Archive, class Finer>
void describe_finer(Archive& archive, Finer& finer) {
    archive.type("recomputed");
    archive.choice("outcome", finer.outcome, kOutcomes, "outcome");
    archive.plain_real("fitness", finer.score);
    archive.choice("verdict", finer.verdict, kVerdicts, "verdict");
}

template <class Archive, class Confirmed>
void describe_confirmed(Archive& archive, Confirmed& confirmed) {
    archive.type("confirmed");
    archive.integer("worlds", confirmed.worlds, 1, kMostWorlds);
    archive.plain_real("median", confirmed.median);
    archive.plain_real("lowest", confirmed.lowest);
    archive.plain_real("highest", confirmed.highest);
}

template <class Archive, class Settings>
void describe_settings(Archive& archive, Settings& settings,
                       const std::vector<ScoreTable>& tables) {
    for (const ScoreTable& table : tables) {
        if (!archive.has(table.name.c_str())) continue;
        archive.object(table.name.c_str(), JsonLayout::kLines, [&](Archive& inner) {
            inner.type(table.name.c_str());
            for (const SettingField& field : table.fields)
                inner.setting(field, settings);
        });
    }
}

template <class Archive, class Genomes>
void describe_opponents(Archive& archive, Genomes& opponents, const KindNames& names) {
    archive.optional_list(
        "opponents", opponents, kMostOpponents, JsonLayout::kLines,
        [&](Archive& inner, auto& genome) { describe_opponent(inner, genome, names); });
}

// The world of a creature without a score.
template <class Archive, class Genomes, class Settings>
void describe_world(Archive& archive, Genomes& opponents, Settings& settings,
                    const std::vector<ScoreTable>& tables, const KindNames& names) {
    archive.type("world");
    describe_settings(archive, settings, tables);
    describe_opponents(archive, opponents, names);
}

template <class Archive, class Scored, class Genomes, class Settings>
void describe_scored(Archive& archive, Scored& scored, Genomes& opponents, Settings& settings,
                     const std::vector<ScoreTable>& tables, const KindNames& names) {
    archive.type("scored");
    describe_settings(archive, settings, tables);
    archive.text("simulator", scored.simulator, kMaxWord);
    archive.integer("seed", scored.seed, 0, kMaxSeed);
    archive.plain_real("fitness", scored.fitness);
    archive.text("unit", scored.unit, kMaxWord);
    archive.optional_object("confirmed", scored.confirmed, JsonLayout::kCompact,
                            [](Archive& inner, auto& each) { describe_confirmed(inner, each); });
    archive.digest("trajectory", scored.trajectory);
    archive.optional_bytes("ticks", scored.ticks, kTicksASecond, kMostTickChecks);
    archive.optional_object("recomputed", scored.finer, JsonLayout::kCompact,
                            [](Archive& inner, auto& finer) { describe_finer(inner, finer); });
    describe_opponents(archive, opponents, names);
}

// Appends a document without a score, on one line.
void write_genotype(std::string& text, const Individual& individual, const KindNames& names);

}  // namespace cambrian::creature_format
