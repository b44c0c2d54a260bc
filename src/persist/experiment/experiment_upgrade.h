#pragma once

// Upgrades experiments of older versions. Throws DatabaseError.

#include "core/result.h"
#include "persist/sqlite/database.h"

#include <optional>

namespace cambrian {

// Upgrades the tables to this program's version, one step for each version, and checks them. Fails
// if the database is no experiment, too new or damaged. Call it in a transaction, and commit only
// after the tables have been read.
Status bring_up_to_date(Database& database);

// Does the same for a database that is only read: it returns an upgraded copy of an older one, or
// nothing if the version is current.
Result<std::optional<Database>> newer_copy(const Database& database);

}  // namespace cambrian
