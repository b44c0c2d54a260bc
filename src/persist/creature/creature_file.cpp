#include "persist/creature/creature_file.h"

#include "core/files/file_io.h"
#include "core/text/counted.h"
#include "core/text/number_text.h"
#include "evolution/evaluation/evaluation.h"
#include "evolution/individual/ancestry_digest.h"
#include "evolution/settings/goal_defaults.h"
#include "evolution/settings/trial_work.h"
#include "genome/founders/disabled_kinds.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/creature_format.h"
#include "persist/creature/page_document.h"
#include "persist/creature/png_file.h"
#include "persist/json/json_reader.h"
#include "persist/text/digest_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

using namespace creature_format;

constexpr std::size_t kMaxFormat = 4096;  // bytes; only used in a message
// Bytes that tell pages and pictures from JSON.
constexpr std::size_t kLongestBeginning = 16;

void check_trial(JsonReader& reader, const ExperimentSettings& settings) {
    const auto excess = trial_excess(settings.world);
    reader.require(!excess, "E07", "trial", [&] { return *excess; });
}

void read_world(JsonReader& reader, CreatureText& text, ExperimentSettings& settings,
                const EvolutionKinds& kinds) {
    describe_world(reader, text.opponents, settings, score_tables(kinds),
                   names_of(kinds.creature.catalog));
    check_trial(reader, settings);
}

void read_scored(JsonReader& reader, CreatureText& text, ExperimentSettings& settings,
                 const EvolutionKinds& kinds) {
    ScoreText& scored = text.scored.emplace();
    describe_scored(reader, scored, text.opponents, settings, score_tables(kinds),
                    names_of(kinds.creature.catalog));
    settings.seed = scored.seed;
    check_trial(reader, settings);
}

// Files of version 4 are of creatures in space, and others are not.
void check_dimensions(double version, int expected, JsonReader& reader, ErrorList& errors) {
    double dimensions = 2.0;
    if (reader.has("dimensions")) reader.plain_real("dimensions", dimensions);
    const double known = version == kVersionOfSpace ? 3.0 : 2.0;
    if (dimensions != known) {
        errors.error("E04", "/dimensions",
                     fmt::format("{}, but a file of version {} has {}", short_text(dimensions),
                                 short_text(version), short_text(known)));
    } else if (dimensions != expected) {
        errors.error("E04", "/dimensions",
                     fmt::format("the creature lives in {} dimensions, expected {}",
                                 short_text(dimensions), expected));
    }
}

// Checks the kind and version of the file; only a known version is read further.
bool read_header(const JsonValue& root, int dimensions, JsonReader& reader, ErrorList& errors) {
    std::string format;
    if (!reader.has("format")) {
        errors.error("E03", "/format", "missing, expected " + in_quotes(kFormat));
        return false;
    }
    reader.text("format", format, kMaxFormat);
    if (errors.empty() && format != kFormat) {
        errors.error(
            "E03", "/format",
            fmt::format("this is a {}, expected {}", in_quotes(format), in_quotes(kFormat)));
    }
    if (!errors.empty()) return false;
    double version = 1.0;
    reader.plain_real("version", version);
    const JsonValue* found = root.find("version");
    if (version > kVersionOfSpace) {
        errors.error("E04", "/version",
                     fmt::format("{} is newer than this program ({})", short_text(version),
                                 kVersionOfSpace));
    } else if (found != nullptr && (version < 1.0 || version != std::floor(version))) {
        errors.error("E04", "/version", "not a positive whole number");
    } else {
        check_dimensions(version, dimensions, reader, errors);
    }
    return errors.empty();
}

void read_document(JsonReader& reader, CreatureText& text, ExperimentSettings& settings,
                   const EvolutionKinds& kinds) {
    const KindNames names = names_of(kinds.creature.catalog);
    describe_identity(reader, text, names);
    describe_genes(reader, text.genome, names);
    if (reader.has("scored")) {
        reader.object("scored", JsonLayout::kLines,
                      [&](JsonReader& inner) { read_scored(inner, text, settings, kinds); });
    } else if (reader.has("world")) {
        reader.object("world", JsonLayout::kLines,
                      [&](JsonReader& inner) { read_world(inner, text, settings, kinds); });
    }
    if (reader.has("check")) reader.digest("check", text.check);
    reader.end();
}

// An error happens only if a gene has a rule that the reader does not know.
void check_genome(const Genome& genome, const std::string& place, const KindCatalog& catalog,
                  ErrorList& errors) {
    for (const std::string& fault : validate(genome, catalog))
        errors.error("E07", place, fault);
}

// Removes unreachable nodes (W02) and compares the stored hash (W03, unless 0).
void finish_genome(Genome& genome, std::uint64_t check, const KindCatalog& catalog,
                   ErrorList& errors) {
    const bool unchanged = check == 0 || check == genome_hash(genome);
    const std::size_t nodes = genome.nodes.size();
    repair(genome, catalog);
    if (genome.nodes.size() < nodes) {
        const std::size_t removed = nodes - genome.nodes.size();
        errors.warn(
            "W02", "/nodes",
            fmt::format("{} cannot be reached from the root, removed", counted(removed, "node")));
    }
    if (!unchanged) {
        errors.warn("W03", "/check", "does not match: the creature was changed by hand");
    }
    check_genome(genome, "", catalog, errors);
}

void finish_opponents(CreatureText& text, const KindCatalog& catalog, ErrorList& errors) {
    const char* table = text.scored ? "scored" : "world";
    for (std::size_t i = 0; i < text.opponents.size(); ++i) {
        repair(text.opponents[i], catalog);
        check_genome(text.opponents[i], fmt::format("/{}/opponents/{}", table, i), catalog, errors);
    }
}

// Ignores numbers of creatures that are none (W05).
void finish_identity(CreatureText& text, ErrorList& errors) {
    const auto check = [&errors](std::string& uid, const std::string& place) {
        if (uid.empty() || parse_hex(uid)) return;
        errors.warn("W05", place, "is not a number of 1 to 16 hexadecimal digits, ignored");
        uid.clear();
    };
    check(text.uid, "/uid");
    for (std::size_t i = 0; i < text.parents.size(); ++i)
        check(text.parents[i], fmt::format("/parents/{}", i));
}

// Restores the individual. Of its result, the file has the fitness and what replays are compared
// with.
Individual individual_of(CreatureText text) {
    Individual individual;
    individual.uid = parse_hex(text.uid).value_or(0);
    individual.genome_hash = genome_hash(text.genome);
    individual.genome = std::make_shared<const Genome>(std::move(text.genome));
    const std::size_t parents = std::min(text.parents.size(), individual.parents.size());
    for (std::size_t i = 0; i < parents; ++i)
        individual.parents[i] = parse_hex(text.parents[i]).value_or(0);
    individual.method = std::move(text.method);
    if (!text.scored) return individual;
    individual.evaluated = true;
    individual.result.fitness = text.scored->fitness;
    individual.result.digest = text.scored->trajectory;
    individual.result.finer = text.scored->finer;
    return individual;
}

CreatureDocument document_of(CreatureText text, ExperimentSettings settings,
                             std::vector<std::string> warnings) {
    CreatureDocument document;
    document.ancestry = text.ancestry;
    for (Genome& opponent : text.opponents)
        settings.world.opponents.genomes.push_back(
            std::make_shared<const Genome>(std::move(opponent)));
    if (ScoreText* scored = text.scored ? &*text.scored : nullptr) {
        document.notes = {.confirmed = scored->confirmed,
                          .unit = std::move(scored->unit),
                          .ticks = std::move(scored->ticks),
                          .simulator = std::move(scored->simulator)};
    }
    document.creature.individual =
        std::make_shared<const Individual>(individual_of(std::move(text)));
    document.creature.settings = std::make_shared<const ExperimentSettings>(std::move(settings));
    document.warnings = std::move(warnings);
    return document;
}

// The identity and parents of an individual, as describe_identity() writes them.
struct Identity {
    const Genome& genome;
    std::string uid;
    std::vector<std::string> parents;
    const std::string& method;
    std::optional<std::uint64_t> ancestry = {};
};

Identity identity_of(const Individual& individual, std::string uid) {
    Identity identity{*individual.genome, std::move(uid), {}, individual.method};
    for (const std::uint64_t parent : individual.parents) {
        if (parent != 0) identity.parents.push_back(hex_text(parent));
    }
    return identity;
}

std::vector<Genome> opponents_of(const CreatureDocument& document) {
    std::vector<Genome> opponents;
    for (const GenomePtr& opponent : document.settings().world.opponents.genomes)
        opponents.push_back(*opponent);
    return opponents;
}

ScoreText score_text(const CreatureDocument& document) {
    return {.simulator = document.notes.simulator,
            .seed = document.settings().seed,
            .fitness = document.score(),
            .unit = document.notes.unit,
            .confirmed = document.notes.confirmed,
            .trajectory = document.result().digest,
            .ticks = document.notes.ticks,
            .finer = document.result().finer};
}

// Whether the recorded trial has the motion of the scored one, as far as one trial tells.
bool is_of(const CreatureDocument& document, const NotedTrial& noted) {
    return document.settings().world.trial.trials > 1 || noted.digest == document.result().digest;
}

std::optional<ConfirmedScore> confirmed_score(const EvaluationResult& result) {
    if (result.scores.empty()) return std::nullopt;
    const auto range = std::minmax_element(result.scores.begin(), result.scores.end());
    return ConfirmedScore{.median = result.fitness,
                          .lowest = *range.first,
                          .highest = *range.second,
                          .worlds = static_cast<int>(result.scores.size())};
}

}  // namespace

void creature_format::write_genotype(std::string& text, const Individual& individual,
                                     const KindNames& names) {
    JsonWriter writer(text, JsonLayout::kDense);
    begin_document(writer, *individual.genome);
    const Identity identity = identity_of(individual, hex_text(individual.uid));
    describe_identity(writer, identity, names);
    describe_genes(writer, *individual.genome, names);
    writer.digest("check", individual.genome_hash);
    writer.end();
}

int dimensions_of_creature(std::string_view text) {
    ErrorList errors;
    const auto root = parse_json(text, {}, errors);
    if (!root || root->kind != JsonValue::Kind::kObject) return 2;
    const JsonValue* named = root->find("dimensions");
    return named != nullptr && named->number == 3.0 ? 3 : 2;
}

Result<CreatureDocument> parse_creature(std::string_view text, std::string_view source,
                                        const EvolutionKinds& kinds) {
    ErrorList errors;
    const auto root = parse_json(text, {}, errors);
    if (!root) return errors.as_error(source);
    if (root->kind != JsonValue::Kind::kObject) {
        errors.error("E06", "", std::string("expected an object, found ") + root->kind_in_words());
        return errors.as_error(source);
    }
    JsonReader reader(*root, {}, errors);
    const int dimensions = kinds.creature.scene.dimensions;
    if (!read_header(*root, dimensions, reader, errors)) return errors.as_error(source);
    CreatureText read;
    read.genome.dimensions = dimensions;
    ExperimentSettings settings;
    if (dimensions == 3) adopt_space_defaults(settings, kinds.goals);
    read_document(reader, read, settings, kinds);
    if (!errors.empty()) return errors.as_error(source);
    finish_identity(read, errors);
    finish_genome(read.genome, read.check, kinds.creature.catalog, errors);
    finish_opponents(read, kinds.creature.catalog, errors);
    if (!errors.empty()) return errors.as_error(source);
    return document_of(std::move(read), std::move(settings), errors.warnings());
}

std::string write_creature(const CreatureDocument& document, const EvolutionKinds& kinds) {
    std::string text;
    JsonWriter writer(text);
    begin_document(writer, document.genome());
    const KindNames names = names_of(kinds.creature.catalog);
    const Individual& individual = *document.creature.individual;
    Identity identity = identity_of(individual, uid_text(individual.uid));
    identity.ancestry = document.ancestry;
    describe_identity(writer, identity, names);
    describe_genes(writer, document.genome(), names);
    const std::vector<Genome> opponents = opponents_of(document);
    if (document.scored()) {
        const ScoreText scored = score_text(document);
        writer.object("scored", JsonLayout::kLines, [&](JsonWriter& inner) {
            describe_scored(inner, scored, opponents, document.settings(), score_tables(kinds),
                            names);
        });
    } else if (document.has_world()) {
        writer.object("world", JsonLayout::kLines, [&](JsonWriter& inner) {
            describe_world(inner, opponents, document.settings(), score_tables(kinds), names);
        });
    }
    writer.digest("check", genome_hash(document.genome()));
    writer.end();
    return text + "\n";
}

bool CreatureDocument::has_world() const {
    return !scored() && !same_judgement(settings(), ExperimentSettings{});
}

bool same_score(const CreatureDocument& a, const CreatureDocument& b) {
    if (!a.scored() || !b.scored()) return a.scored() == b.scored();
    return same_judgement(a.settings(), b.settings()) && a.settings().seed == b.settings().seed &&
           a.score() == b.score() && a.result().digest == b.result().digest &&
           a.result().finer == b.result().finer && a.notes == b.notes;
}

Result<std::string> read_creature_text(const std::filesystem::path& path) {
    const Result<std::string> start = read_start(path, kLongestBeginning);
    if (!start) return start.error();
    if (is_page(*start)) {
        const Result<std::string> page = read_file(path, kMaxPageBytes);
        return page ? page_document(*page, path.string()) : page;
    }
    if (!is_png(*start)) return read_file(path, JsonLimits{}.bytes);
    const Result<std::string> card = read_file(path, kMaxCardBytes);
    return card ? card_document(*card, path.string()) : card;
}

Result<CreatureDocument> load_creature(const std::filesystem::path& path,
                                       const EvolutionKinds& kinds) {
    Result<std::string> text = read_creature_text(path);
    if (!text) return text.error();
    return parse_creature(*text, path.string(), kinds);
}

Status save_creature(const std::filesystem::path& path, const CreatureDocument& document,
                     const EvolutionKinds& kinds) {
    return write_file(path, write_creature(document, kinds));
}

std::vector<std::string> foreign_kinds(const Genome& genome, const FounderSettings& settings,
                                       const EvolutionKinds& kinds) {
    std::vector<std::string> messages;
    for (const DisabledKind& kind : disabled_kinds(genome, settings, kinds.creature.catalog)) {
        std::string message = "W04 ";
        message.append(kind.place).append(": ").append(kind.what);
        messages.push_back(message + " is not enabled in this experiment");
    }
    return messages;
}

CreatureDocument creature_document(JudgedIndividual creature, const EvolutionKinds& kinds) {
    CreatureDocument document;
    document.ancestry = ancestry_digest(*creature.individual);
    const EvaluationResult& result = creature.individual->result;
    document.notes.confirmed = confirmed_score(result);
    document.notes.unit = goal_unit(creature.settings->goal, kinds.goals);
    document.notes.simulator = simulator_version(creature.settings->world.environment.dimensions);
    const bool unfinished = result.outcome == Outcome::kStoppedEarly;  // it has no final score
    if (unfinished) creature.individual = without_score(*creature.individual);
    document.creature = std::move(creature);
    return document;
}

void complete_score(CreatureDocument& document, const EvolutionKinds& kinds,
                    const std::stop_token& stop) {
    if (!document.scored()) return;
    if (document.notes.ticks.empty()) {
        auto noted = note_ticks(document.genome(), document.settings(), kinds, stop);
        if (noted && is_of(document, *noted)) document.notes.ticks = std::move(noted->ticks);
    }
    if (document.result().finer) return;
    const FinerResult finer = recompute(document.genome(), document.settings(), kinds, stop);
    if (finer.outcome == Outcome::kInterrupted) return;
    change_individual(document.creature, [&](Individual& each) { each.result.finer = finer; });
}

}  // namespace cambrian
