#include "persist/records/experiment_schema.h"

#include <fmt/core.h>

#include <map>
#include <string>

namespace cambrian {
namespace {

constexpr std::size_t kLongestDefinition = 20'000;  // bytes of a table's

// Returns the definitions of the tables of version 2.
std::string tables() {
    return "CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;"
           "CREATE TABLE settings (id INTEGER PRIMARY KEY, toml TEXT NOT NULL);"
           "CREATE TABLE journal (id INTEGER PRIMARY KEY, generation INTEGER NOT NULL, "
           "command TEXT NOT NULL, settings INTEGER, share, size INTEGER, genotype BLOB);"
           "CREATE TABLE individuals (id INTEGER PRIMARY KEY, uid INTEGER NOT NULL, "
           "born INTEGER NOT NULL, body_born INTEGER NOT NULL, parent1 INTEGER NOT NULL, "
           "parent2 INTEGER NOT NULL, mother INTEGER, method TEXT NOT NULL, mutations TEXT, "
           "genome_hash INTEGER NOT NULL, fitness, outcome TEXT NOT NULL, "
           "verdict TEXT NOT NULL, digest INTEGER NOT NULL, parts INTEGER NOT NULL, "
           "neurons INTEGER NOT NULL);"
           "CREATE TABLE genotypes (individual INTEGER PRIMARY KEY, size INTEGER NOT NULL, "
           "document BLOB NOT NULL);"
           "CREATE TABLE results (individual INTEGER NOT NULL, judged INTEGER NOT NULL, "
           "outcome TEXT NOT NULL, verdict TEXT NOT NULL, finer_outcome TEXT, finer_fitness, "
           "finer_verdict TEXT, " +
           column_definitions<EvaluationResult>(kResultColumns) + ", " +
           column_definitions<Behavior>(kBehaviorColumns) + ", " +
           column_definitions<SceneAudit>(kAuditColumns) +
           ", PRIMARY KEY (individual, judged)) WITHOUT ROWID;"
           "CREATE TABLE population (place INTEGER PRIMARY KEY, individual INTEGER NOT NULL, "
           "judged INTEGER NOT NULL);"
           "CREATE TABLE novel (place INTEGER PRIMARY KEY, individual INTEGER NOT NULL, "
           "judged INTEGER NOT NULL);"
           "CREATE TABLE generations (" +
           column_definitions<GenerationStatistics>(kStatisticsColumns) +
           ", champion INTEGER NOT NULL, champion_judged INTEGER NOT NULL, "
           "settings INTEGER NOT NULL, population_digest INTEGER NOT NULL, "
           "audited INTEGER NOT NULL, audited_survivors INTEGER NOT NULL, novelty_threshold, "
           "novelty_quiet INTEGER NOT NULL, PRIMARY KEY (generation));"
           "CREATE TABLE grids (number INTEGER PRIMARY KEY, parent INTEGER, origin TEXT NOT NULL, "
           "cells INTEGER NOT NULL, boldness TEXT NOT NULL, fitness_weight, "
           "generations INTEGER NOT NULL, settings INTEGER NOT NULL, picks TEXT NOT NULL);"
           "CREATE TABLE grid_cells (grid INTEGER NOT NULL, cell INTEGER NOT NULL, "
           "individual INTEGER NOT NULL, judged INTEGER NOT NULL, PRIMARY KEY (grid, cell)) "
           "WITHOUT ROWID;"
           "CREATE TABLE kept (role TEXT NOT NULL, place INTEGER NOT NULL, "
           "individual INTEGER NOT NULL, judged INTEGER NOT NULL, generation INTEGER NOT NULL, "
           "settings INTEGER NOT NULL, PRIMARY KEY (role, place)) WITHOUT ROWID;"
           "CREATE TABLE simulators (generation INTEGER PRIMARY KEY, version TEXT NOT NULL);"
           "CREATE VIEW champions AS SELECT generation, best, median, "
           "printf('%016x', uid) AS uid, method, parts, neurons, champion AS individual "
           "FROM generations JOIN individuals ON id = champion;";
}

template <class Row>
void add_columns(Database& database, const char* table, std::span<const Column<Row>> columns) {
    for (const Column<Row>& column : columns) {
        const bool whole = !std::holds_alternative<double Row::*>(column.field);
        database.execute(fmt::format("ALTER TABLE {} ADD COLUMN {}{}", table, column.name,
                                     whole ? " INTEGER NOT NULL DEFAULT 0" : ""));
    }
}

std::map<std::string, std::string> statements_of(const Database& database) {
    std::map<std::string, std::string> statements;
    Statement schema =
        database.prepare("SELECT name, sql FROM sqlite_schema WHERE type = 'table' LIMIT 1000");
    while (schema.step())
        statements.emplace(schema.text(0), schema.text(1, kLongestDefinition));
    return statements;
}

}  // namespace

void add_lines_and_confirmations(Database& database) {
    database.execute("ALTER TABLE individuals ADD COLUMN line INTEGER NOT NULL DEFAULT 0");
    add_columns<EvaluationResult>(database, "results", kLaterResultColumns);
    database.execute("ALTER TABLE results ADD COLUMN scores TEXT");
    add_columns<GenerationStatistics>(database, "generations", kLaterStatisticsColumns);
    database.execute(
        "CREATE TABLE births (generation INTEGER NOT NULL, line INTEGER NOT NULL, "
        "births INTEGER NOT NULL, PRIMARY KEY (generation, line)) WITHOUT ROWID");
}

void create_tables(Database& database) {
    database.execute(fmt::format("PRAGMA application_id = {}", kExperimentApplication));
    database.execute(fmt::format("PRAGMA user_version = {}", kExperimentVersion));
    database.execute(tables());
    add_lines_and_confirmations(database);
}

Result<std::int64_t> version_of_tables(const Database& database) {
    const std::int64_t application = database.integer("PRAGMA application_id");
    if (application == kPreserveApplication)
        return Error{
            "it is a preserve, no experiment; `cambrian preserve --resume` goes on with it"};
    if (application != kExperimentApplication)
        return Error{"it is empty or another program's database"};
    const std::int64_t version = database.integer("PRAGMA user_version");
    if (version > kExperimentVersion) {
        return Error{fmt::format("its version {} is newer than this program ({})", version,
                                 kExperimentVersion)};
    }
    if (version < 1) return Error{fmt::format("its version {} never existed", version)};
    return version;
}

// Tables of other programs are ignored.
Status check_tables(const Database& database) {
    Database model({}, Database::Access::kCreate);
    model.execute(tables());
    add_lines_and_confirmations(model);
    const auto found = statements_of(database);
    for (const auto& [name, sql] : statements_of(model)) {
        const auto table = found.find(name);
        if (table == found.end()) return Error{fmt::format("table \"{}\" is missing", name)};
        if (table->second != sql)
            return Error{fmt::format("table \"{}\" has other columns than expected", name)};
    }
    return {};
}

}  // namespace cambrian
