#pragma once

// The files beside a database can come from strangers, too. SQLite deletes the file that a rollback
// journal names as its super-journal, whatever file that is.

#include <filesystem>

namespace cambrian {

// Throws DatabaseError if the rollback journal beside a database names another file.
void check_journal(const std::filesystem::path& database);

// Returns the name of a file system for sqlite3_open_v2() that opens no super-journals, so that
// SQLite can delete none.
const char* safe_file_system();

}  // namespace cambrian
