#pragma once

// Experiments of older versions. Throws DatabaseError.

#include "core/result.h"
#include "persist/sqlite/database.h"

#include <optional>

namespace cambrian {

// Brings the tables up to this program's version, a step a version, and checks them. Fails if it is
// no experiment, too new or damaged. Belongs into a transaction that is committed only once what
// the tables hold has been read.
Status bring_up_to_date(Database& database);

// The same for a database that is only to be read: a copy of an older one that was brought up to
// date, none of one that is.
Result<std::optional<Database>> newer_copy(const Database& database);

}  // namespace cambrian
