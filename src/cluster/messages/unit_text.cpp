#include "cluster/messages/unit_text.h"

#include "cluster/messages/exact_real.h"
#include "cluster/messages/message_text.h"
#include "cluster/messages/work_queue.h"
#include "core/assert.h"
#include "genome/gene_fields.h"
#include "persist/creature/creature_file.h"

#include <fmt/core.h>

#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostDocument = 500'000;        // bytes, of one creature
constexpr std::size_t kMostDocuments = 32'000'000;    // bytes of all documents, inflated
constexpr std::size_t kMostOutlineBytes = 1'000'000;  // bytes of the line before them
const MessageKind kUnitKind{"cambrian-unit", kUnitVersion};

constexpr FieldRule kDeadline{.name = "deadline",
                              .key = "deadline",
                              .low = 1e-3,
                              .high = std::numeric_limits<double>::max(),
                              .fallback = 0.0};

// The entry of one creature in the line: its trial and the length of its document.
struct Entry {
    std::uint32_t slot = 0;
    std::uint64_t trial_seed = 0;
    std::uint64_t genome_hash = 0;
    std::size_t bytes = 0;
    std::optional<TerminationThreshold> threshold;
    std::optional<Probe> probe;
};

struct Outline {
    UnitTerms terms;
    std::vector<Entry> entries;
};

template <class Archive, class Terms>
void describe_terms(Archive& archive, Terms& terms) {
    archive.digest("settings", terms.settings);
    archive.text("simulator", terms.simulator, kLongestVersion);
    archive.digest("proof", terms.proof);
    archive.real("deadline", terms.deadline, kDeadline);
}

template <class Archive, class Described>
void describe_entry(Archive& archive, Described& entry) {
    archive.integer("slot", entry.slot, 0.0, kMostSlot);
    archive.digest("seed", entry.trial_seed);
    archive.digest("genome", entry.genome_hash);
    archive.integer("bytes", entry.bytes, 1.0, static_cast<double>(kMostDocument));
    archive.optional_object("bar", entry.threshold, JsonLayout::kCompact,
                            [](Archive& inner, auto& threshold) {
                                exact_real(inner, "score", threshold.score);
                                inner.flag("audited", threshold.audited);
                            });
    archive.optional_object("probe", entry.probe, JsonLayout::kCompact,
                            [](Archive& inner, auto& probe) {
                                inner.digest("seed", probe.seed);
                                inner.flag("finer", probe.finer);
                            });
}

template <class Archive, class Described>
void describe_outline(Archive& archive, Described& outline) {
    describe_terms(archive, outline.terms);
    archive.list("creatures", outline.entries, 1, kMostUnitCreatures, JsonLayout::kCompact,
                 [](Archive& inner, auto& entry) { describe_entry(inner, entry); });
}

constexpr JsonLimits kUnitLimits{
    .bytes = kMostOutlineBytes, .depth = 5, .values = 16 * kMostUnitCreatures, .keys = 16};

// Splits a body into its first line and the rest.
std::pair<std::string_view, std::string_view> line_and_rest(std::string_view body) {
    const std::size_t end = body.find('\n');
    if (end == std::string_view::npos) return {body, {}};
    return {body.substr(0, end), body.substr(end + 1)};
}

Error too_large(std::size_t bytes, std::size_t most) {
    return {fmt::format("{}: {} bytes, limit {}", kUnitKind.format, bytes, most)};
}

Result<GenomePtr> read_genome(std::string_view document, const Entry& entry,
                              const EvolutionKinds& kinds) {
    Result<CreatureDocument> creature = parse_creature(document, kUnitKind.format, kinds);
    if (!creature) return creature.error();
    if (creature->creature.individual->genome_hash != entry.genome_hash)
        return Error{fmt::format("{}: the genome of slot {} is not the one that was sent",
                                 kUnitKind.format, entry.slot)};
    return creature->creature.individual->genome;
}

}  // namespace

UnitWriter::UnitWriter(const EvolutionKinds& kinds)
    : names_(creature_format::names_of(kinds.creature.catalog)) {}

std::string UnitWriter::write(const UnitTerms& terms, std::span<const EvaluationRequest> requests) {
    CAMBRIAN_ASSERT(!requests.empty() && requests.size() <= kMostUnitCreatures, "a unit's size");
    Outline outline{.terms = terms, .entries = {}};
    documents_.clear();
    for (const EvaluationRequest& request : requests) {
        Individual individual;
        individual.genome = request.genome;
        individual.genome_hash = genome_hash(*request.genome);
        const std::size_t start = documents_.size();
        creature_format::write_genotype(documents_, individual, names_);
        outline.entries.push_back({.slot = request.slot,
                                   .trial_seed = request.trial_seed,
                                   .genome_hash = individual.genome_hash,
                                   .bytes = documents_.size() - start,
                                   .threshold = request.threshold,
                                   .probe = request.probe});
    }
    std::string body = write_message(
        kUnitKind, outline,
        [](JsonWriter& writer, const Outline& each) { describe_outline(writer, each); });
    body += '\n';
    body += deflater_.deflate(documents_);
    return body;
}

Result<UnitOutline> parse_unit_outline(std::string_view body) {
    if (body.size() > kMostUnitBytes) return too_large(body.size(), kMostUnitBytes);
    ErrorList errors;
    const auto root = parse_object(line_and_rest(body).first, kUnitLimits, errors);
    if (!errors.empty()) return errors.as_error(kUnitKind.format);
    JsonReader reader(*root, {}, errors);
    UnitOutline outline;
    outline.version = read_version(reader, kUnitKind.format, errors);
    if (errors.empty() && outline.version == kUnitVersion) describe_terms(reader, outline.terms);
    if (!errors.empty()) return errors.as_error(kUnitKind.format);
    return outline;
}

Result<Unit> UnitReader::read(std::string_view body) {
    if (body.size() > kMostUnitBytes) return too_large(body.size(), kMostUnitBytes);
    const auto [line, deflated] = line_and_rest(body);
    const Result<Outline> outline = read_message<Outline>(
        kUnitKind, line, kUnitLimits,
        [](JsonReader& reader, Outline& each) { describe_outline(reader, each); });
    if (!outline) return outline.error();
    std::size_t bytes = 0;
    for (const Entry& entry : outline->entries)
        bytes += entry.bytes;
    if (bytes > kMostDocuments) return too_large(bytes, kMostDocuments);
    const Result<std::string> documents = inflater_.inflate(deflated, bytes);
    if (!documents)
        return Error{fmt::format("{}: {}", kUnitKind.format, documents.error().message)};
    Unit unit{.terms = outline->terms, .requests = {}};
    std::string_view rest = *documents;
    for (const Entry& entry : outline->entries) {
        Result<GenomePtr> genome = read_genome(rest.substr(0, entry.bytes), entry, kinds_);
        if (!genome) return genome.error();
        rest.remove_prefix(entry.bytes);
        unit.requests.push_back({.genome = *std::move(genome),
                                 .trial_seed = entry.trial_seed,
                                 .slot = entry.slot,
                                 .threshold = entry.threshold,
                                 .probe = entry.probe});
    }
    return unit;
}

}  // namespace cambrian
