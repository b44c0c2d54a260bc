#pragma once

// Preserve files, *.cambrian: the settings and founders of a preserve, its lives, its series, and
// snapshots from which it goes on. assets/help/preserve.md describes the tables for users.

#include "core/result.h"
#include "evolution/kinds/evolution_kinds.h"
#include "preserve/engine/preserve_log.h"
#include "preserve/preserve.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

// Returns whether a file is one of a preserve, rather than of an experiment. False if it cannot be
// read.
bool is_preserve_file(const std::filesystem::path& path);

// All that a preserve follows from.
struct PreserveOrigin {
    SettingsPtr settings;
    std::vector<GenomePtr> founders;
    std::string simulator;  // version that began it
};

// A snapshot that a file has.
struct SnapshotEntry {
    std::uint64_t tick = 0;
    std::uint64_t digest = 0;
};

struct SavedPreserve {
    PreserveOrigin origin;
    std::vector<SnapshotEntry> snapshots;     // in ascending order of ticks
    std::vector<Intervention> interventions;  // of people, in their order
};

// Reads a file, which may be in use, without changing it. Fails if it is not a preserve file.
Result<SavedPreserve> load_preserve(const std::filesystem::path& path, const EvolutionKinds& kinds);
// Reads one of its snapshots; fails if it is damaged or its digest is another one.
Result<PreserveState> load_snapshot(const std::filesystem::path& path, const SnapshotEntry& entry,
                                    const EvolutionKinds& kinds);

// Return all lives or the series as CSV with a line of names.
Result<std::string> lives_csv(const std::filesystem::path& path);
Result<std::string> series_csv(const std::filesystem::path& path);

// Reads the museum, in the order in which creatures came into it. Files of earlier versions have
// none.
Result<std::vector<MuseumPiece>> load_museum(const std::filesystem::path& path,
                                             const EvolutionKinds& kinds);

// Copies a file, which may be in use, up to one of its snapshots. An existing file is refused.
Status copy_preserve(const std::filesystem::path& from, std::uint64_t tick,
                     const std::filesystem::path& to, const EvolutionKinds& kinds);

class PreserveFile final : public PreserveLog {
public:
    ~PreserveFile() override;
    PreserveFile(const PreserveFile&) = delete;
    PreserveFile& operator=(const PreserveFile&) = delete;

    // Makes a file with the preserve's beginning and what happened in it; an existing file is
    // refused.
    static Result<std::unique_ptr<PreserveFile>> create(const std::filesystem::path& path,
                                                        const PreserveOrigin& origin,
                                                        const Chronicle& chronicle,
                                                        const Preserve& preserve,
                                                        const EvolutionKinds& kinds);
    struct Opened;
    // Opens a file to go on from its last snapshot that is sound. What it has of later times is
    // removed, since it will be computed again.
    static Result<Opened> open(const std::filesystem::path& path, const EvolutionKinds& kinds);

    // Writes what happened, and the snapshot if one was taken. It is on the disk when this returns.
    Status write(const Chronicle& chronicle, const Preserve& preserve) override;
    Status keep_pins(const Pins& pins) override;
    std::vector<std::uint64_t> snapshots() const override { return snapshots_; }

private:
    struct Parts;
    explicit PreserveFile(std::unique_ptr<Parts> parts);
    // Opens a file that was just made.
    static Result<std::unique_ptr<PreserveFile>> begun_in(const std::filesystem::path& path,
                                                          const EvolutionKinds& kinds);
    Status change(const std::function<void()>& rows);

    std::unique_ptr<Parts> parts_;
    std::vector<std::uint64_t> snapshots_;  // ticks
};

struct PreserveFile::Opened {
    std::unique_ptr<PreserveFile> file;
    PreserveOrigin origin;
    PreserveState state;
    SettingsPtr laws;  // in force at that state
    std::vector<SeriesRow> series;
    std::vector<MuseumPiece> museum;
    Pins pins;
    std::vector<std::string> warnings;  // about what is damaged
};

}  // namespace cambrian
