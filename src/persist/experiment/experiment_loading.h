#pragma once

// Reads an experiment file of any readable version without changing it.

#include "core/result.h"
#include "persist/experiment/experiment_upgrade.h"
#include "persist/sqlite/read_only_database.h"

#include <fmt/core.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace cambrian {

// Returns the Result<Part> of `read(const Database&)`, called with tables of the newest version. It
// reads again if the file changed meanwhile (persist/sqlite/read_only_database.h).
template <class Part, class Read>
Result<Part> load_from_experiment(const std::filesystem::path& path, Read read) {
    const auto refusal = [&path](const std::string& reason) {
        return Error{fmt::format("cannot open {}: {}", path.string(), reason)};
    };
    try {
        std::optional<Result<Part>> part;
        read_database(path, [&](const Database& database) {
            database.prepare("BEGIN").run();  // what others write meanwhile is not seen
            const Result<std::optional<Database>> newer = newer_copy(database);
            if (newer) {
                part = read(*newer ? **newer : database);
            } else {
                part = refusal(newer.error().message);
            }
        });
        return std::move(*part);
    } catch (const DatabaseError& error) {
        return refusal(error.what());
    }
}

}  // namespace cambrian
