#include "persist/experiment/experiment_upgrade.h"

#include "persist/records/experiment_schema.h"

#include <fmt/core.h>

#include <array>
#include <map>
#include <string>
#include <utility>

namespace cambrian {
namespace {

// Version 1 did not record the simulator's version; there was only one.
void name_simulators(Database& database) {
    database.execute(
        "CREATE TABLE simulators (generation INTEGER PRIMARY KEY, version TEXT NOT NULL);"
        "INSERT INTO simulators VALUES (0, '1.0')");
}

// Version 2 did not name the founder of each line of descent. It is the last known mother of the
// line. A mother has a lower row than her child.
void trace_lines(Database& database) {
    std::map<std::int64_t, std::int64_t> lines;  // by row
    Statement row = database.prepare(
        "SELECT id, mother, CASE parent1 WHEN 0 THEN uid ELSE parent1 END FROM individuals "
        "ORDER BY id");
    while (row.step()) {
        const auto mother = lines.find(row.is_null(1) ? 0 : row.integer(1));
        lines.emplace(row.integer(0), mother == lines.end() ? row.integer(2) : mother->second);
    }
    Statement update = database.prepare("UPDATE individuals SET line = ? WHERE id = ?");
    for (const auto& [id, line] : lines)
        update.run(line, id);
}

void add_lines(Database& database) {
    add_lines_and_confirmations(database);
    trace_lines(database);
    database.execute("UPDATE generations SET best_lowest = best, best_highest = best");
}

// Version 3 did not tune offspring and had no rhythmic founders.
void keep_old_breeding(Database& database) {
    database.execute(
        "UPDATE settings SET toml = toml || char(10) || '[population]' || char(10) "
        "WHERE instr(toml, '[population]') = 0;"
        "UPDATE settings SET toml = replace(toml, '[population]', "
        "'[population]' || char(10) || 'tuned = 0.0' || char(10) || 'rhythmic = 0.0') "
        "WHERE instr(toml, 'rhythmic') = 0");
}

// The steps: from version 1, from version 2, and so on.
constexpr std::array kSteps = {name_simulators, add_lines, keep_old_breeding};
static_assert(kSteps.size() + 1 == kExperimentVersion);

}  // namespace

Status bring_up_to_date(Database& database) {
    const Result<std::int64_t> version = version_of_tables(database);
    if (!version) return version.error();
    for (std::int64_t i = *version; i < kExperimentVersion; ++i) {
        kSteps[static_cast<std::size_t>(i - 1)](database);
        database.execute(fmt::format("PRAGMA user_version = {}", i + 1));
    }
    return check_tables(database);
}

Result<std::optional<Database>> newer_copy(const Database& database) {
    const Result<std::int64_t> version = version_of_tables(database);
    if (!version) return version.error();
    if (*version == kExperimentVersion) {
        if (Status whole = check_tables(database); !whole) return whole.error();
        return std::optional<Database>();
    }
    Database copied = database.copy();
    if (Status current = bring_up_to_date(copied); !current) return current.error();
    return std::optional<Database>(std::move(copied));
}

}  // namespace cambrian
