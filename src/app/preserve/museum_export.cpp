#include "app/preserve/museum_export.h"

#include "core/files/file_io.h"
#include "persist/creature/creature_file.h"
#include "persist/preserve/preserve_file.h"
#include "preserve/laws.h"

#include <fmt/core.h>

#include <system_error>
#include <vector>

namespace cambrian {
namespace {

// "creature-12-lineage.creature.json"
std::string file_name(const MuseumPiece& piece) {
    return fmt::format("creature-{}-{}.creature.json", piece.number, piece.reason);
}

bool has_known_reason(const MuseumPiece& piece) {
    return piece.reason == museum_reason::kLineage || piece.reason == museum_reason::kChildren;
}

Status check_folder(const std::filesystem::path& folder, const std::vector<MuseumPiece>& museum) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        return Error{
            fmt::format("cannot make the folder {}: {}", folder.string(), failure.message())};
    for (const MuseumPiece& piece : museum) {
        const std::filesystem::path path = folder / file_name(piece);
        if (std::filesystem::exists(path, failure))
            return Error{
                fmt::format("{} exists; expected a folder without such files", path.string())};
        if (Status writable = check_writable(path); !writable) return writable;
    }
    return {};
}

// Returns the settings of trials under the laws of the last snapshot.
Result<SettingsPtr> settings_of_trials(const std::string& file, const EvolutionKinds& kinds) {
    const Result<SavedPreserve> saved = load_preserve(file, kinds);
    if (!saved) return saved.error();
    const Result<SettingsPtr> laws =
        laws_at(saved->origin.settings, saved->interventions, saved->snapshots.back().tick, kinds);
    return laws ? Result(trial_settings(*laws, kinds)) : laws.error();
}

}  // namespace

Result<std::string> export_museum(const std::string& file, const std::filesystem::path& folder,
                                  const EvolutionKinds& kinds) {
    Result<std::vector<MuseumPiece>> museum = load_museum(file, kinds);
    if (!museum) return museum.error();
    std::erase_if(*museum, [](const MuseumPiece& piece) { return !has_known_reason(piece); });
    if (museum->empty())
        return Error{fmt::format(
            "{}: the museum is empty; expected a lineage that reached {} living members, or 10 min "
            "of the world's time",
            file, kMembersForMuseum)};
    const Result<SettingsPtr> settings = settings_of_trials(file, kinds);
    if (!settings) return settings.error();
    if (Status free = check_folder(folder, *museum); !free) return free.error();
    std::string names;
    for (const MuseumPiece& piece : *museum) {
        const CreatureDocument document{unjudged(piece.genome, *settings, piece.reason)};
        const Status written = save_creature(folder / file_name(piece), document, kinds);
        if (!written) return written.error();
        names += file_name(piece) + '\n';
    }
    return names;
}

}  // namespace cambrian
