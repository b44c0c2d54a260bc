#include "persist/preserve/preserve_tables.h"
#include "persist/records/experiment_schema.h"
#include "persist/settings/settings_file.h"
#include "simulator/simulator_version.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

constexpr std::uint64_t kRecentSnapshots = 10;
constexpr std::uint64_t kTicksPerHour = 60 * kTicksPerSnapshot;

constexpr const char* kMuseumTable =
    "CREATE TABLE museum (number INTEGER NOT NULL, reason TEXT NOT NULL, tick INTEGER NOT NULL, "
    "count INTEGER NOT NULL, PRIMARY KEY (number, reason)) WITHOUT ROWID;";

std::string preserve_tables() {
    return "CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
           "CREATE TABLE founders (number INTEGER PRIMARY KEY, size INTEGER NOT NULL, "
           "document BLOB NOT NULL);"
           "CREATE TABLE lives (" +
           column_definitions<LifeRow>(kLifeColumns) +
           ", PRIMARY KEY (number));"
           "CREATE TABLE genotypes (number INTEGER PRIMARY KEY, size INTEGER NOT NULL, "
           "document BLOB NOT NULL, base INTEGER NOT NULL DEFAULT 0);"
           "CREATE TABLE series (" +
           column_definitions<SeriesRow>(kSeriesColumns) +
           ", PRIMARY KEY (tick));"
           "CREATE TABLE interventions (id INTEGER PRIMARY KEY, tick INTEGER NOT NULL, "
           "what TEXT NOT NULL, number INTEGER NOT NULL, x REAL NOT NULL DEFAULT 0, "
           "y REAL NOT NULL DEFAULT 0, to_x REAL NOT NULL DEFAULT 0, to_y REAL NOT NULL DEFAULT 0);"
           "CREATE TABLE snapshots (tick INTEGER PRIMARY KEY, digest INTEGER NOT NULL, "
           "size INTEGER NOT NULL, state BLOB NOT NULL);" +
           kMuseumTable;
}

// Returns the words as bytes, the lowest byte of each first.
std::string bytes_of(const std::vector<std::uint64_t>& words) {
    std::string bytes;
    bytes.reserve(8 * words.size());
    for (const std::uint64_t word : words) {
        for (int shift = 0; shift < 64; shift += 8)
            bytes.push_back(static_cast<char>(static_cast<std::uint8_t>(word >> shift)));
    }
    return bytes;
}

Individual individual_of(const GenomePtr& genome) {
    Individual individual;
    individual.genome = genome;
    return individual;
}

}  // namespace

LifeRow row_of(const Life& life) {
    return {.number = life.number,
            .uid = life.uid,
            .parent1 = life.parents[0],
            .parent2 = life.parents[1],
            .lineage = life.lineage,
            .method = life.method,
            .mutations = life.mutations,
            .born = life.born,
            .died = life.died,
            .cause = std::string(kDeathCauses[static_cast<std::size_t>(life.cause)]),
            .x = life.x,
            .y = life.y,
            .mass = life.mass,
            .parts = life.parts,
            .neurons = life.neurons,
            .diet = life.diet,
            .eaten_plants = joules(life.eaten_plants),
            .eaten_flesh = joules(life.eaten_flesh),
            .bitten = joules(life.bitten),
            .lost = joules(life.lost),
            .children = life.children};
}

void create_preserve_tables(Database& database) {
    database.execute(fmt::format("PRAGMA application_id = {}", kPreserveApplication));
    database.execute(fmt::format("PRAGMA user_version = {}", kPreserveVersion));
    database.execute(preserve_tables());
}

Status check_preserve_tables(const Database& database) {
    const std::int64_t application = database.integer("PRAGMA application_id");
    if (application == kExperimentApplication)
        return Error{
            "it is an experiment, no preserve; `cambrian evolve --resume` goes on with it"};
    if (application != kPreserveApplication)
        return Error{"it is empty or another program's database"};
    const std::int64_t version = database.integer("PRAGMA user_version");
    if (version >= 1 && version <= kPreserveVersion) return {};
    return Error{
        fmt::format("its version {} is not that of this program ({})", version, kPreserveVersion)};
}

void upgrade_preserve_tables(Database& database) {
    const std::int64_t version = database.integer("PRAGMA user_version");
    if (version == kPreserveVersion) return;
    Transaction transaction(database);
    if (version == 1) {
        database.execute(
            "ALTER TABLE interventions ADD COLUMN x REAL NOT NULL DEFAULT 0;"
            "ALTER TABLE interventions ADD COLUMN y REAL NOT NULL DEFAULT 0;");
    }
    if (version <= 2) {
        database.execute(
            "ALTER TABLE interventions ADD COLUMN to_x REAL NOT NULL DEFAULT 0;"
            "ALTER TABLE interventions ADD COLUMN to_y REAL NOT NULL DEFAULT 0;");
    }
    if (version <= 3) database.execute(kMuseumTable);
    if (version <= 5)
        database.execute("ALTER TABLE genotypes ADD COLUMN base INTEGER NOT NULL DEFAULT 0");
    database.execute(fmt::format("PRAGMA user_version = {}", kPreserveVersion));
    transaction.commit();
}

PreserveWriter::PreserveWriter(Database& database, const EvolutionKinds& kinds)
    : database_(database),
      kinds_(kinds),
      put_life_(database.prepare(fmt::format("INSERT OR REPLACE INTO lives VALUES (?{})",
                                             more_places(kLifeColumns.size() - 1)))),
      put_genotype_(database.prepare("INSERT OR REPLACE INTO genotypes VALUES (?, ?, ?, ?)")),
      put_founder_(database.prepare("INSERT INTO founders VALUES (?, ?, ?)")),
      put_series_(database.prepare(
          fmt::format("INSERT INTO series VALUES (?{})", more_places(kSeriesColumns.size() - 1)))),
      put_intervention_(
          database.prepare("INSERT INTO interventions (tick, what, number, x, y, to_x, to_y) "
                           "VALUES (?, ?, ?, ?, ?, ?, ?)")),
      put_snapshot_(database.prepare("INSERT OR REPLACE INTO snapshots VALUES (?, ?, ?, ?)")),
      put_piece_(database.prepare("INSERT OR IGNORE INTO museum VALUES (?, ?, ?, ?)")),
      packer_(kinds),
      genotypes_(database, kinds) {}

void PreserveWriter::put_founder(std::size_t number, const GenomePtr& genome) {
    const PackedGenotype packed = packer_.pack(individual_of(genome));
    put_founder_.bind(std::uint64_t{number}, std::uint64_t{packed.size});
    put_founder_.bind_bytes(packed.bytes);
    put_founder_.finish();
}

// Writes the difference from the first parent's genotype, if that can be read.
void PreserveWriter::put_genotype(const Life& life) {
    const Individual individual = individual_of(life.genome);
    std::uint64_t base = life.parents[0];
    const Result<KeptText> kept = genotypes_.text(base);
    if (!kept || kept->differences == kMostDifferences) base = 0;
    const PackedGenotype packed =
        base == 0 ? packer_.pack(individual) : packer_.pack_difference(individual, kept->text);
    put_genotype_.bind(life.number, std::uint64_t{packed.size});
    put_genotype_.bind_bytes(packed.bytes);
    put_genotype_.bind_next(base);
    put_genotype_.finish();
}

void PreserveWriter::begin(const PreserveOrigin& origin) {
    Statement fact = database_.prepare("INSERT INTO facts VALUES (?, ?)");
    fact.run("kind", "preserve");
    fact.run("simulator", origin.simulator);
    fact.run("settings", write_settings(*origin.settings, kinds_, SettingsUse::kPreserve));
    for (std::size_t i = 0; i < origin.founders.size(); ++i)
        put_founder(i + 1, origin.founders[i]);
}

void PreserveWriter::put_life(const Life& life) {
    put_life_.restart();
    bind_columns<LifeRow>(put_life_, kLifeColumns, row_of(life));
    put_life_.finish();
}

void PreserveWriter::put_snapshot(const PreserveState& state) {
    const std::vector<std::uint64_t> words = words_of(state);
    put_snapshot_.bind(state.tick, digest_of(words), std::uint64_t{words.size()});
    Deflater deflater;
    put_snapshot_.bind_bytes(deflater.deflate(bytes_of(words)));
    put_snapshot_.finish();
}

// Keeps the last snapshots, and one an hour of the earlier ones.
void PreserveWriter::thin_snapshots(std::uint64_t tick) {
    const std::uint64_t recent = kRecentSnapshots * kTicksPerSnapshot;
    if (tick < recent) return;
    database_.prepare("DELETE FROM snapshots WHERE tick <= ? AND tick % ? != 0")
        .run(tick - recent, kTicksPerHour);
}

void PreserveWriter::write(const Chronicle& chronicle, const Preserve& preserve) {
    for (const Life& life : chronicle.born) {
        put_life(life);
        put_genotype(life);
    }
    for (const Life& life : chronicle.died)
        put_life(life);
    for (const auto& resident : preserve.residents())
        put_life(resident->life);
    for (const SeriesRow& row : chronicle.series) {
        put_series_.restart();
        bind_columns<SeriesRow>(put_series_, kSeriesColumns, row);
        put_series_.finish();
    }
    for (const Intervention& each : chronicle.interventions)
        put_intervention_.run(each.tick, each.what, each.number, each.x, each.y, each.to_x,
                              each.to_y);
    for (const MuseumPiece& piece : chronicle.museum)
        put_piece_.run(piece.number, piece.reason, piece.tick, piece.count);
    if (!chronicle.snapshot) return;
    put_snapshot(*chronicle.snapshot);
    thin_snapshots(chronicle.snapshot->tick);
}

void PreserveWriter::put_pins(const Pins& pins) {
    database_.prepare("INSERT OR REPLACE INTO facts VALUES (?, ?)").run(kPinsFact, pins_text(pins));
}

// Interventions at the snapshot's own tick that came after the last rest are not in it.
void PreserveWriter::remove_after(const PreserveState& state) {
    database_
        .prepare(
            "DELETE FROM interventions WHERE tick > ?1 OR (tick = ?1 AND what != 'restock' AND "
            "id > (SELECT coalesce(max(id), 0) FROM interventions WHERE tick = ?1 AND what = "
            "'rest'))")
        .run(state.tick);
    for (const char* sql :
         {"DELETE FROM genotypes WHERE number >= ?", "DELETE FROM lives WHERE number >= ?"})
        database_.prepare(sql).run(state.next_number);
    for (const char* sql :
         {"DELETE FROM series WHERE tick > ?", "DELETE FROM snapshots WHERE tick > ?",
          "DELETE FROM museum WHERE tick > ?"})
        database_.prepare(sql).run(state.tick);
    for (const ResidentState& each : state.residents)
        put_life(each.life);
}

}  // namespace cambrian
