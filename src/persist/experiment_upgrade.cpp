#include "persist/experiment_upgrade.h"

#include "persist/experiment_schema.h"

#include <array>
#include <string>
#include <utility>

namespace cambrian {
namespace {

// Version 1 did not say which simulator had computed what; there was one only.
void name_simulators(Database& database) {
    database.execute(
        "CREATE TABLE simulators (generation INTEGER PRIMARY KEY, version TEXT NOT NULL);"
        "INSERT INTO simulators VALUES (0, '1.0')");
}

// The step from version 1, from version 2...
constexpr std::array kSteps = {name_simulators};
static_assert(kSteps.size() + 1 == kExperimentVersion);

}  // namespace

Status bring_up_to_date(Database& database) {
    const Result<std::int64_t> version = version_of_tables(database);
    if (!version) return version.error();
    for (std::int64_t i = *version; i < kExperimentVersion; ++i) {
        kSteps[static_cast<std::size_t>(i - 1)](database);
        database.execute("PRAGMA user_version = " + std::to_string(i + 1));
    }
    return check_tables(database);
}

Result<Database> up_to_date(Database database) {
    const Result<std::int64_t> version = version_of_tables(database);
    if (!version) return version.error();
    if (*version < kExperimentVersion) database = database.copy();
    if (Status current = bring_up_to_date(database); !current) return current.error();
    return database;
}

}  // namespace cambrian
