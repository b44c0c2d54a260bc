#pragma once

// Reads a database where it lies without leaving a trace: no write access is needed, and no file
// comes to be beside it. What a killed program left beside it is taken into account.

#include "persist/sqlite/database.h"

#include <filesystem>
#include <functional>

namespace cambrian {

// Gives `read` the database as it is at one moment. It may be called again, should another program
// have changed the file meanwhile; what it gave before does not count then. Throws DatabaseError.
void read_database(const std::filesystem::path& path,
                   const std::function<void(const Database&)>& read);

}  // namespace cambrian
