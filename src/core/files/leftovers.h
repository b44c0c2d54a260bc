#pragma once

// Temporary files and folders that a killed process of this program left. Their names have the id
// of the process: PREFIX, the id, "-" and something else. A process that works holds a lock (flock)
// on what it made.

#include <filesystem>
#include <string_view>
#include <sys/types.h>

namespace cambrian {

struct TemporaryName {
    pid_t maker = 0;  // 0 if it is no name of this form
    std::string_view rest;
};
TemporaryName temporary_name(std::string_view name, std::string_view prefix);

// Returns whether the process that made a file or folder has ended. The lock also covers processes
// that are not visible here, and process ids that were used again.
bool is_leftover(const std::filesystem::path& path, pid_t maker);

}  // namespace cambrian
