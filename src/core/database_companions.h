#pragma once

// The files that SQLite keeps beside a database while it is open, and that a killed program leaves.

#include <array>
#include <filesystem>
#include <string_view>

namespace cambrian {

// What is added to the database's name.
inline constexpr std::array<std::string_view, 3> kDatabaseCompanions = {"-wal", "-shm", "-journal"};

// Those that are there.
void remove_companions(const std::filesystem::path& database);

}  // namespace cambrian
