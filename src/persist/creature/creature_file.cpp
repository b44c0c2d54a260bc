#include "persist/creature/creature_file.h"

#include "core/files/file_io.h"
#include "core/text/number_text.h"
#include "evolution/evaluation/evaluation.h"
#include "evolution/individual/ancestry_digest.h"
#include "evolution/settings/trial_work.h"
#include "genome/founders/disabled_kinds.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/creature_format.h"
#include "persist/json/json_reader.h"
#include "persist/text/digest_text.h"

#include <cmath>
#include <utility>

namespace cambrian {
namespace {

using namespace creature_format;

constexpr std::size_t kMaxFormat = 4096;  // bytes; only used in a message

void read_scored(JsonReader& reader, ScoredRecord& scored, const EvolutionKinds& kinds) {
    ExperimentSettings settings;
    describe_scored(reader, scored, settings, score_tables(kinds));
    const auto excess = trial_excess(settings.world);
    reader.require(!excess, "E07", "trial", excess.value_or(""));
    scored.world = settings.world;
    scored.expression = settings.expression;
    scored.goal = settings.goal;
}

// Checks the kind and version of the file; only a known version is read further.
bool read_header(const JsonValue& root, JsonReader& reader, ErrorList& errors) {
    std::string format;
    if (!reader.has("format")) {
        errors.error("E03", "/format", "missing, expected " + in_quotes(kFormat));
        return false;
    }
    reader.text("format", format, kMaxFormat);
    if (errors.empty() && format != kFormat) {
        errors.error("E03", "/format",
                     "this is a " + in_quotes(format) + ", expected " + in_quotes(kFormat));
    }
    if (!errors.empty()) return false;
    double version = 1.0;
    reader.plain_real("version", version);
    const JsonValue* found = root.find("version");
    if (version > kVersion) {
        errors.error(
            "E04", "/version",
            short_text(version) + " is newer than this program (" + std::to_string(kVersion) + ")");
    } else if (found != nullptr && (version < 1.0 || version != std::floor(version))) {
        errors.error("E04", "/version", "not a positive whole number");
    }
    return errors.empty();
}

void read_document(JsonReader& reader, CreatureDocument& document, std::uint64_t& check,
                   const EvolutionKinds& kinds) {
    describe_identity(reader, document);
    describe_genes(reader, document.genome, names_of(kinds.creature.catalog));
    if (reader.has("scored")) {
        reader.object("scored", Layout::kLines, [&](JsonReader& inner) {
            read_scored(inner, document.scored.emplace(), kinds);
        });
    }
    if (reader.has("check")) reader.digest("check", check);
    reader.end();
}

// Removes unreachable nodes (W02) and compares the stored hash (W03, unless 0).
void finish_genome(Genome& genome, std::uint64_t check, const KindCatalog& catalog,
                   ErrorList& errors) {
    const bool unchanged = check == 0 || check == genome_hash(genome);
    const std::size_t nodes = genome.nodes.size();
    repair(genome, catalog);
    if (genome.nodes.size() < nodes) {
        const std::size_t removed = nodes - genome.nodes.size();
        errors.warn("W02", "/nodes",
                    std::to_string(removed) + (removed == 1 ? " node" : " nodes") +
                        " cannot be reached from the root, removed");
    }
    if (!unchanged) {
        errors.warn("W03", "/check", "does not match: the creature was changed by hand");
    }
    // This happens only if a gene has a rule that the reader does not know.
    for (const std::string& fault : validate(genome, catalog))
        errors.error("E07", "", fault);
}

std::vector<std::string> parents_of(const Individual& individual) {
    std::vector<std::string> parents;
    for (const std::uint64_t parent : individual.parents) {
        if (parent != 0) parents.push_back(hex_text(parent));
    }
    return parents;
}

// The identity and parents of an individual, as describe_identity() writes them.
struct Identity {
    const Genome& genome;
    std::string uid;
    std::vector<std::string> parents;
    const std::string& method;
    std::optional<std::uint64_t> ancestry = {};
};

// Whether the recorded trial has the motion of the scored one, as far as one trial tells.
bool is_of(const ScoredRecord& scored, const NotedTrial& noted) {
    return scored.world.trial.trials > 1 || noted.digest == scored.trajectory;
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
    JsonWriter writer(text, Layout::kCompact);
    begin_document(writer);
    const Identity identity{*individual.genome, hex_text(individual.uid), parents_of(individual),
                            individual.method};
    describe_identity(writer, identity);
    describe_genes(writer, *individual.genome, names);
    writer.digest("check", individual.genome_hash);
    writer.end();
}

Result<CreatureDocument> parse_creature(std::string_view text, std::string_view source,
                                        const EvolutionKinds& kinds) {
    ErrorList errors;
    CreatureDocument document;
    std::uint64_t check = 0;
    const auto root = parse_json(text, {}, errors);
    if (!root) return errors.as_error(source);
    if (root->kind != JsonValue::Kind::kObject) {
        errors.error("E06", "", std::string("expected an object, found ") + root->kind_in_words());
        return errors.as_error(source);
    }
    JsonReader reader(*root, "", errors);
    if (!read_header(*root, reader, errors)) return errors.as_error(source);
    read_document(reader, document, check, kinds);
    if (!errors.empty()) return errors.as_error(source);
    finish_genome(document.genome, check, kinds.creature.catalog, errors);
    if (!errors.empty()) return errors.as_error(source);
    document.warnings = errors.warnings();
    return document;
}

std::string write_creature(const CreatureDocument& document, const EvolutionKinds& kinds) {
    std::string text;
    JsonWriter writer(text);
    begin_document(writer);
    describe_identity(writer, document);
    describe_genes(writer, document.genome, names_of(kinds.creature.catalog));
    if (document.scored) {
        const ExperimentSettings settings = settings_of(*document.scored);
        writer.object("scored", Layout::kLines, [&](JsonWriter& inner) {
            describe_scored(inner, *document.scored, settings, score_tables(kinds));
        });
    }
    writer.digest("check", genome_hash(document.genome));
    writer.end();
    return text + "\n";
}

Result<std::string> read_creature_text(const std::filesystem::path& path) {
    const Result<bool> card_inside = is_card(path);
    if (!card_inside) return card_inside.error();
    if (!*card_inside) return read_file(path, JsonLimits{}.bytes);
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

CreatureDocument creature_document(const Individual& individual, const ExperimentSettings& settings,
                                   const EvolutionKinds& kinds) {
    CreatureDocument document;
    document.genome = *individual.genome;
    document.uid = hex_text(individual.uid);
    document.method = individual.method;
    document.parents = parents_of(individual);
    document.ancestry = ancestry_digest(individual);
    if (!individual.evaluated || individual.result.outcome == Outcome::kStoppedEarly)
        return document;  // a trial that was terminated early has no final score
    document.scored = ScoredRecord{.world = settings.world,
                                   .expression = settings.expression,
                                   .goal = settings.goal,
                                   .seed = settings.seed,
                                   .fitness = unconfirmed_score(individual.result),
                                   .confirmed = confirmed_score(individual.result),
                                   .unit = goal_unit(settings.goal, kinds.goals),
                                   .trajectory = individual.result.digest,
                                   .finer = individual.result.finer};
    return document;
}

void complete_score(CreatureDocument& document, const EvolutionKinds& kinds,
                    const std::stop_token& stop) {
    if (!document.scored) return;
    ScoredRecord& scored = *document.scored;
    const ExperimentSettings settings = settings_of(scored);
    if (scored.ticks.empty()) {
        auto noted = note_ticks(document.genome, settings, kinds, stop);
        if (noted && is_of(scored, *noted)) scored.ticks = std::move(noted->ticks);
    }
    if (scored.finer) return;
    const FinerResult finer = recompute(document.genome, settings, kinds, stop);
    if (finer.outcome != Outcome::kInterrupted) scored.finer = finer;
}

}  // namespace cambrian
