#include "core/text/shown_text.h"
#include "persist/preserve/preserve_tables.h"
#include "persist/settings/settings_file.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr std::int64_t kMostWords = kMostSnapshotBytes / 8;
constexpr std::size_t kMostDeflation = 1032;     // bytes from one of deflated data
constexpr std::size_t kLongestFact = 1'000'000;  // bytes; settings are the longest
constexpr std::size_t kLongestPins = 2'200'000;  // bytes
constexpr std::size_t kMostFounders = 1000;
constexpr int kMostSnapshots = 100'000;
constexpr int kMostInterventions = 1'000'000;
constexpr int kMostPieces = 100'000;   // of the museum
constexpr int kMostRows = 10'000'000;  // of the series

std::string fact(const Database& database, const char* name) {
    Statement row = database.prepare("SELECT value FROM facts WHERE name = ?");
    row.bind(name);
    if (!row.step()) throw DatabaseError(fmt::format("the fact \"{}\" is missing", name));
    return std::string(row.text(0, kLongestFact));
}

// Returns the settings' text. Where it does not say how many of the founders are rhythmic, the file
// was made before any could be.
std::string settings_text(const Database& database) {
    constexpr std::string_view kTable = "[preserve]\n";
    std::string text = fact(database, "settings");
    const std::size_t table = text.find(kTable);
    if (table != std::string::npos && text.find("\nrhythmic = ") == std::string::npos)
        text.insert(table + kTable.size(), "rhythmic = 0.0\n");
    return text;
}

GenomePtr sound(const Result<GenomePtr>& genome) {
    if (!genome) throw DatabaseError(genome.error().message);
    return *genome;
}

std::vector<GenomePtr> read_founders(const Database& database, const EvolutionKinds& kinds) {
    std::vector<GenomePtr> founders;
    GenotypeReader genotypes(kinds);
    Statement row = database.prepare("SELECT size, document FROM founders ORDER BY number");
    while (row.step()) {
        if (founders.size() == kMostFounders) throw DatabaseError("it has too many founders");
        founders.push_back(sound(genotypes.read(row.bytes(1), row.integer(0))));
    }
    if (founders.empty()) throw DatabaseError("it has no founders");
    return founders;
}

std::vector<std::uint64_t> words_in(std::string_view bytes) {
    std::vector<std::uint64_t> words(bytes.size() / 8);
    for (std::size_t i = 0; i < 8 * words.size(); ++i)
        words[i / 8] |= std::uint64_t{static_cast<std::uint8_t>(bytes[i])} << (8 * (i % 8));
    return words;
}

// Returns what people did, in order. Files of version 1 have none.
std::vector<Intervention> read_interventions(const Database& database,
                                             const EvolutionKinds& kinds) {
    std::vector<Intervention> all;
    const std::int64_t version = database.integer("PRAGMA user_version");
    if (version == 1) return all;
    KeptGenotypes genotypes(database, kinds);
    Statement row = database.prepare(fmt::format(
        "SELECT tick, what, interventions.number, x, y, genotypes.number, {} FROM interventions "
        "LEFT JOIN genotypes ON what = 'add' AND genotypes.number = interventions.number WHERE "
        "what != 'restock' ORDER BY id LIMIT ?",
        version == 2 ? "0.0, 0.0" : "to_x, to_y"));
    row.bind(kMostInterventions);
    while (row.step()) {
        Intervention& each = all.emplace_back();
        read_column(row, 0, each.tick);
        each.what = row.word(1);
        read_column(row, 2, each.number);
        each.x = row.real(3);
        each.y = row.real(4);
        each.to_x = row.real(6);
        each.to_y = row.real(7);
        if (each.what == intervention::kAdd && !row.is_null(5))
            each.genome = sound(genotypes.genome(each.number));
        if (all.size() > 1 && each.tick < all[all.size() - 2].tick)
            throw DatabaseError("its interventions are not in order");
    }
    return all;
}

}  // namespace

std::optional<Pins> read_pins(const Database& database) {
    Statement row = database.prepare("SELECT value FROM facts WHERE name = ?");
    row.bind(kPinsFact);
    return row.step() ? pins_of(row.text(0, kLongestPins)) : Pins();
}

std::vector<std::uint64_t> read_snapshot_ticks(const Database& database) {
    std::vector<std::uint64_t> ticks;
    Statement row = database.prepare("SELECT tick FROM snapshots ORDER BY tick LIMIT ?");
    row.bind(kMostSnapshots);
    while (row.step())
        read_column(row, 0, ticks.emplace_back());
    return ticks;
}

std::vector<SeriesRow> read_series(const Database& database) {
    std::vector<SeriesRow> rows;
    Statement row =
        database.prepare(fmt::format("SELECT {} FROM series ORDER BY tick LIMIT {}",
                                     column_names<SeriesRow>(kSeriesColumns), kMostRows));
    while (row.step())
        read_columns<SeriesRow>(row, 0, kSeriesColumns, rows.emplace_back());
    return rows;
}

std::vector<MuseumPiece> read_museum(const Database& database, const EvolutionKinds& kinds) {
    std::vector<MuseumPiece> museum;
    if (database.integer("PRAGMA user_version") <= 3) return museum;
    KeptGenotypes genotypes(database, kinds);
    Statement row = database.prepare(
        "SELECT number, tick, reason, count FROM museum JOIN genotypes USING (number) "
        "ORDER BY tick, number, reason LIMIT ?");
    row.bind(kMostPieces);
    while (row.step()) {
        MuseumPiece& piece = museum.emplace_back();
        read_column(row, 0, piece.number);
        read_column(row, 1, piece.tick);
        piece.reason = row.word(2);
        read_column(row, 3, piece.count);
        piece.genome = sound(genotypes.genome(piece.number));
    }
    return museum;
}

SavedPreserve read_preserve(const Database& database, const EvolutionKinds& kinds) {
    SavedPreserve saved;
    Result<ExperimentSettings> settings =
        parse_settings(settings_text(database), "settings", kinds, SettingsUse::kPreserve);
    if (!settings) throw DatabaseError(settings.error().message);
    saved.origin.settings = std::make_shared<const ExperimentSettings>(*std::move(settings));
    saved.origin.simulator = shown(fact(database, "simulator"), 64);
    saved.origin.founders = read_founders(database, kinds);
    Statement row = database.prepare("SELECT tick, digest FROM snapshots ORDER BY tick LIMIT ?");
    row.bind(kMostSnapshots);
    while (row.step()) {
        SnapshotEntry entry;
        read_column(row, 0, entry.tick);
        read_column(row, 1, entry.digest);
        if (!saved.snapshots.empty() && entry.tick <= saved.snapshots.back().tick)
            throw DatabaseError("its snapshots are not in order");
        saved.snapshots.push_back(entry);
    }
    if (saved.snapshots.empty()) throw DatabaseError("it has no snapshot");
    saved.interventions = read_interventions(database, kinds);
    return saved;
}

Result<PreserveState> read_snapshot(const Database& database, const SnapshotEntry& entry,
                                    const EvolutionKinds& kinds) {
    Statement row = database.prepare("SELECT size, state FROM snapshots WHERE tick = ?");
    row.bind(entry.tick);
    if (!row.step()) return Error{"the snapshot is missing"};
    const std::int64_t size = row.integer(0);
    if (size < 0 || size > kMostWords)
        return Error{
            fmt::format("the snapshot has {} numbers; expected at most {}", size, kMostWords)};
    const std::size_t length = 8 * static_cast<std::size_t>(size);
    if (length / kMostDeflation > row.bytes(1).size())
        return Error{"the snapshot has fewer numbers than it says"};
    const Result<std::string> bytes = Inflater().inflate(row.bytes(1), length);
    if (!bytes) return bytes.error();
    const std::vector<std::uint64_t> words = words_in(*bytes);
    if (digest_of(words) != entry.digest)
        return Error{"the snapshot is not the one that was written"};
    KeptGenotypes genotypes(database, kinds);
    Statement method = database.prepare("SELECT method FROM lives WHERE number = ?");
    Result<PreserveState> state = state_of(words, [&](std::uint64_t number) -> Result<Origin> {
        const Result<GenomePtr> genome = genotypes.genome(number);
        if (!genome) return genome.error();
        method.bind(number);
        if (!method.step()) return Error{fmt::format("creature {} is missing", number)};
        return Origin{*genome, method.word(0)};
    });
    if (state && state->tick != entry.tick) return Error{"the snapshot is of another time"};
    return state;
}

}  // namespace cambrian
