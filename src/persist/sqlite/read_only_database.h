#pragma once

// Reads a database in place without write access and without creating files beside it. It includes
// the log that a killed program may have left.

#include "persist/sqlite/database.h"

#include <filesystem>
#include <functional>

namespace cambrian {

// Calls `read` with a consistent state of the database. It calls it again if another program
// changed the file meanwhile, and drops the earlier result. Throws DatabaseError.
void read_database(const std::filesystem::path& path,
                   const std::function<void(const Database&)>& read);

}  // namespace cambrian
