#include "persist/experiment_parts.h"

#include "core/pending_file.h"
#include "persist/experiment_reader.h"
#include "persist/experiment_schema.h"
#include "persist/experiment_upgrade.h"
#include "persist/read_only_database.h"

#include <optional>
#include <string>
#include <utility>

namespace cambrian {
namespace {

// What `read` makes of the database, brought up to date.
template <class Part, class Read>
Result<Part> load_part(const std::filesystem::path& path, Read read) {
    const auto refusal = [&path](const std::string& reason) {
        return Error{"cannot open " + path.string() + ": " + reason};
    };
    try {
        std::optional<Result<Part>> part;
        read_database(path, [&](const Database& database) {
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

}  // namespace

Result<SettingsPtr> load_last_settings(const std::filesystem::path& path,
                                       const EvolutionKinds& kinds) {
    return load_part<SettingsPtr>(path, [&](const Database& database) -> Result<SettingsPtr> {
        return read_last_settings(database, kinds);
    });
}

Result<std::vector<GenerationStatistics>> load_history(const std::filesystem::path& path) {
    using History = std::vector<GenerationStatistics>;
    return load_part<History>(path, [&](const Database& database) -> Result<History> {
        History history = read_history(database);
        if (history.empty()) return Error{path.string() + ": no generation has been finished yet"};
        return history;
    });
}

Status copy_experiment(const std::filesystem::path& from, const std::filesystem::path& to) {
    const auto refusal = [&from](const std::string& reason) {
        return Error{"cannot copy " + from.string() + ": " + reason};
    };
    std::error_code unknown;
    if (std::filesystem::exists(to, unknown))
        return Error{"cannot keep the experiment in " + to.string() + ": File exists"};
    try {
        std::optional<PendingFile> file;
        Status copied;
        read_database(from, [&](const Database& database) {
            file.reset();
            const Result<std::int64_t> version = version_of_tables(database);
            Result<PendingFile> made = PendingFile::beside(to);
            if (!version || !made) {
                copied = version ? made.error() : refusal(version.error().message);
                return;
            }
            file.emplace(std::move(*made));
            database.copy_to(file->path());
        });
        if (!copied) return copied;
        Database(file->path(), Database::Access::kWrite).make_durable();
        return file->commit(PendingFile::Existing::kRefuse);
    } catch (const DatabaseError& error) {
        return refusal(error.what());
    }
}

}  // namespace cambrian
