#include "persist/experiment/experiment_parts.h"

#include "core/files/pending_file.h"
#include "persist/creature/rescoring.h"
#include "persist/experiment/experiment_loading.h"
#include "persist/experiment/experiment_reader.h"
#include "persist/records/experiment_schema.h"
#include "persist/sqlite/read_only_database.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace cambrian {
Result<SettingsPtr> load_last_settings(const std::filesystem::path& path,
                                       const EvolutionKinds& kinds) {
    return load_from_experiment<SettingsPtr>(path,
                                             [&](const Database& database) -> Result<SettingsPtr> {
                                                 return read_last_settings(database, kinds);
                                             });
}

Result<std::vector<GenerationStatistics>> load_history(const std::filesystem::path& path) {
    using History = std::vector<GenerationStatistics>;
    return load_from_experiment<History>(path, [&](const Database& database) -> Result<History> {
        History history = read_history(database);
        if (history.empty()) return Error{path.string() + ": no generation has been finished yet"};
        return history;
    });
}

std::vector<std::uint32_t> spread_generations(std::uint32_t last, std::size_t most) {
    std::vector<std::uint32_t> spread;
    for (std::size_t i = 0; i < most; ++i) {
        const auto next = static_cast<std::uint32_t>(last * i / std::max<std::size_t>(1, most - 1));
        if (spread.empty() || next > spread.back()) spread.push_back(next);
    }
    return spread;
}

Result<KeptChampion> load_champion(const std::filesystem::path& path,
                                   const std::optional<std::uint32_t>& generation,
                                   const EvolutionKinds& kinds) {
    return load_from_experiment<KeptChampion>(
        path, [&](const Database& database) -> Result<KeptChampion> {
            const std::int64_t last =
                database.integer("SELECT ifnull(max(generation), -1) FROM generations");
            if (last < 0) return Error{path.string() + ": no generation has been finished yet"};
            const std::int64_t wanted = generation.value_or(static_cast<std::uint32_t>(last));
            if (wanted > last) {
                return Error{fmt::format("{}: has no generation {}; the last is {}", path.string(),
                                         wanted, last)};
            }
            KeptChampion kept;
            kept.creature = read_champion(database, static_cast<std::uint32_t>(wanted), kinds);
            const auto only = read_only_simulator(database);
            // Otherwise it depends on the last generation in which all creatures were evaluated.
            kept.simulator =
                only ? *only
                     : scored_by(read_experiment(database, kinds).saved,
                                 kept.creature.individual->born, kept.creature.generation);
            return kept;
        });
}

Status copy_experiment(const std::filesystem::path& from, const std::filesystem::path& to) {
    const auto refusal = [&from](const std::string& reason) {
        return Error{fmt::format("cannot copy {}: {}", from.string(), reason)};
    };
    std::error_code unknown;
    if (std::filesystem::exists(to, unknown))
        return Error{fmt::format("cannot keep the experiment in {}: File exists", to.string())};
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
        remove_companions(file->target());
        return file->commit(PendingFile::Existing::kRefuse);
    } catch (const DatabaseError& error) {
        return refusal(error.what());
    }
}

}  // namespace cambrian
