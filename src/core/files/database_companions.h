#pragma once

// The files that SQLite creates beside an open database, which remain if the program is killed.

#include <array>
#include <filesystem>
#include <string_view>

namespace cambrian {

// Suffixes of the database's name.
inline constexpr std::array<std::string_view, 3> kDatabaseCompanions = {"-wal", "-shm", "-journal"};

// Returns whether there are changes, or data to undo some, that the database itself does not have.
bool has_unwritten_changes(const std::filesystem::path& database);

// Deletes those that exist.
void remove_companions(const std::filesystem::path& database);

}  // namespace cambrian
