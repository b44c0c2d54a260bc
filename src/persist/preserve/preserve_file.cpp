#include "persist/preserve/preserve_file.h"

#include "core/files/database_companions.h"
#include "core/files/file_io.h"
#include "core/files/file_lock.h"
#include "core/files/pending_file.h"
#include "core/text/number_text.h"
#include "persist/preserve/preserve_tables.h"
#include "persist/records/experiment_schema.h"
#include "persist/sqlite/column_text.h"
#include "persist/sqlite/read_only_database.h"
#include "preserve/laws.h"

#include <fmt/core.h>

#include <cerrno>
#include <optional>
#include <system_error>
#include <utility>

namespace cambrian {
namespace {

Error preserve_failure(const char* task, const std::filesystem::path& path,
                       const std::string& reason) {
    return Error{fmt::format("{} {}: {}", task, path.string(), reason)};
}

constexpr const char* kKeepingPreserve = "cannot keep the preserve in";
constexpr const char* kOpeningPreserve = "cannot open";

Database writable(const std::filesystem::path& path) {
    Database database(path, Database::Access::kWrite);
    database.allow_values_of(kMostSnapshotBytes);
    return database;
}

// Returns the Result<Part> of `read(const Database&)` of a preserve file.
template <class Part, class Read>
Result<Part> load_from_preserve(const std::filesystem::path& path, Read read) {
    try {
        std::optional<Result<Part>> part;
        read_database(path, [&](const Database& database) {
            database.allow_values_of(kMostSnapshotBytes);
            database.prepare("BEGIN").run();  // what others write meanwhile is not seen
            const Status sound = check_preserve_tables(database);
            part = sound ? read(database)
                         : preserve_failure(kOpeningPreserve, path, sound.error().message);
        });
        return std::move(*part);
    } catch (const DatabaseError& error) {
        return preserve_failure(kOpeningPreserve, path, error.what());
    }
}

template <class Row, std::size_t Count>
Result<std::string> table_csv(const std::filesystem::path& path, const char* table,
                              const std::array<Column<Row>, Count>& columns) {
    return load_from_preserve<std::string>(
        path, [&](const Database& database) -> Result<std::string> {
            std::string text;
            for (const Column<Row>& column : columns)
                text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
            text += '\n';
            Statement statement = database.prepare(
                fmt::format("SELECT {} FROM {} ORDER BY 1", column_names<Row>(columns), table));
            while (statement.step()) {
                Row row;
                read_columns<Row>(statement, 0, columns, row);
                add_cells<Row>(text, row, columns);
                text.back() = '\n';
            }
            return text;
        });
}

double seconds_of(std::uint64_t tick) {
    return static_cast<double>(tick) * kBrainTick;
}

// Returns the last snapshot that can be read, and a warning for each later one.
Result<PreserveState> last_sound_snapshot(const Database& database, const SavedPreserve& saved,
                                          const std::filesystem::path& path,
                                          const EvolutionKinds& kinds,
                                          std::vector<std::string>& warnings) {
    for (auto entry = saved.snapshots.rbegin(); entry != saved.snapshots.rend(); ++entry) {
        Result<PreserveState> state = read_snapshot(database, *entry, kinds);
        if (state) return state;
        warnings.push_back(
            fmt::format("the snapshot of {} s is damaged ({}); going on from the one "
                        "before",
                        short_text(seconds_of(entry->tick)), state.error().message));
    }
    return preserve_failure(kOpeningPreserve, path, "all of its snapshots are damaged");
}

}  // namespace

// The lock outlives the connection, because closing any descriptor of a file releases SQLite's own
// locks on it.
struct PreserveFile::Parts {
    Parts(std::filesystem::path name, FileLock held, Database connection,
          const EvolutionKinds& kinds)
        : path(std::move(name)),
          lock(std::move(held)),
          database(std::move(connection)),
          writer(database, kinds) {}

    std::filesystem::path path;
    FileLock lock;
    Database database;
    PreserveWriter writer;
};

PreserveFile::PreserveFile(std::unique_ptr<Parts> parts)
    : parts_(std::move(parts)), snapshots_(read_snapshot_ticks(parts_->database)) {}

PreserveFile::~PreserveFile() = default;

bool is_preserve_file(const std::filesystem::path& path) {
    bool is = false;
    try {
        read_database(path, [&](const Database& database) {
            is = database.integer("PRAGMA application_id") == kPreserveApplication;
        });
    } catch (const DatabaseError&) {
        return false;
    }
    return is;
}

Result<SavedPreserve> load_preserve(const std::filesystem::path& path,
                                    const EvolutionKinds& kinds) {
    return load_from_preserve<SavedPreserve>(
        path, [&](const Database& database) -> Result<SavedPreserve> {
            return read_preserve(database, kinds);
        });
}

Result<PreserveState> load_snapshot(const std::filesystem::path& path, const SnapshotEntry& entry,
                                    const EvolutionKinds& kinds) {
    return load_from_preserve<PreserveState>(
        path, [&](const Database& database) { return read_snapshot(database, entry, kinds); });
}

Result<std::string> lives_csv(const std::filesystem::path& path) {
    return table_csv(path, "lives", kLifeColumns);
}

Result<std::string> series_csv(const std::filesystem::path& path) {
    return table_csv(path, "series", kSeriesColumns);
}

Result<std::vector<MuseumPiece>> load_museum(const std::filesystem::path& path,
                                             const EvolutionKinds& kinds) {
    return load_from_preserve<std::vector<MuseumPiece>>(
        path, [&](const Database& database) -> Result<std::vector<MuseumPiece>> {
            return read_museum(database, kinds);
        });
}

Status copy_preserve(const std::filesystem::path& from, std::uint64_t tick,
                     const std::filesystem::path& to, const EvolutionKinds& kinds) {
    std::error_code unknown;
    if (std::filesystem::exists(to, unknown))
        return preserve_failure(kKeepingPreserve, to, std::generic_category().message(EEXIST));
    Result<PendingFile> pending = PendingFile::beside(to);
    if (!pending) return pending.error();
    try {
        Status copied = preserve_failure(kOpeningPreserve, from, "it has no such snapshot");
        read_database(from, [&](const Database& database) {
            database.allow_values_of(kMostSnapshotBytes);
            if (Status sound = check_preserve_tables(database); !sound) {
                copied = preserve_failure(kOpeningPreserve, from, sound.error().message);
                return;
            }
            for (const SnapshotEntry& entry : read_preserve(database, kinds).snapshots) {
                if (entry.tick != tick) continue;
                const Result<PreserveState> state = read_snapshot(database, entry, kinds);
                if (!state) {
                    copied = preserve_failure(kOpeningPreserve, from, state.error().message);
                    return;
                }
                database.copy_to(pending->path());
                Database copy = writable(pending->path());
                upgrade_preserve_tables(copy);
                PreserveWriter(copy, kinds).remove_after(*state);
                copied = {};
            }
        });
        if (!copied) return copied;
        remove_companions(pending->target());
        return pending->commit(PendingFile::Existing::kRefuse);
    } catch (const DatabaseError& error) {
        return preserve_failure(kKeepingPreserve, to, error.what());
    }
}

Result<std::unique_ptr<PreserveFile>> PreserveFile::create(const std::filesystem::path& path,
                                                           const PreserveOrigin& origin,
                                                           const Chronicle& chronicle,
                                                           const Preserve& preserve,
                                                           const EvolutionKinds& kinds) {
    std::error_code unknown;
    if (std::filesystem::exists(path, unknown))
        return preserve_failure(kKeepingPreserve, path, std::generic_category().message(EEXIST));
    Result<PendingFile> pending = PendingFile::beside(path);
    if (!pending) return pending.error();
    try {
        {
            Database database = writable(pending->path());
            create_preserve_tables(database);
            database.make_durable();
            Transaction transaction(database);
            PreserveWriter writer(database, kinds);
            writer.begin(origin);
            writer.write(chronicle, preserve);
            transaction.commit();
            database.empty_log();
        }
        remove_companions(pending->target());
        if (Status moved = pending->commit(PendingFile::Existing::kRefuse); !moved)
            return moved.error();
    } catch (const DatabaseError& error) {
        return preserve_failure(kKeepingPreserve, path, error.what());
    }
    Result<std::unique_ptr<PreserveFile>> file = begun_in(path, kinds);
    if (!file) {
        std::filesystem::remove(path, unknown);
        remove_companions(path);
    }
    return file;
}

Result<std::unique_ptr<PreserveFile>> PreserveFile::begun_in(const std::filesystem::path& path,
                                                             const EvolutionKinds& kinds) {
    try {
        Result<FileLock> lock = FileLock::take(path);
        if (!lock) return preserve_failure(kKeepingPreserve, path, lock.error().message);
        Database database = writable(path);
        database.make_durable();
        std::unique_ptr<PreserveFile> file(new PreserveFile(
            std::make_unique<Parts>(path, std::move(*lock), std::move(database), kinds)));
        return file;
    } catch (const DatabaseError& error) {
        return preserve_failure(kKeepingPreserve, path, error.what());
    }
}

Result<PreserveFile::Opened> PreserveFile::open(const std::filesystem::path& path,
                                                const EvolutionKinds& kinds) {
    if (Status writable = check_writable(path); !writable) return writable.error();
    Result<FileLock> lock = FileLock::take(path);
    if (!lock) return preserve_failure(kOpeningPreserve, path, lock.error().message);
    try {
        Database database = writable(path);
        if (Status sound = check_preserve_tables(database); !sound)
            return preserve_failure(kOpeningPreserve, path, sound.error().message);
        upgrade_preserve_tables(database);
        Opened opened;
        SavedPreserve saved = read_preserve(database, kinds);
        Result<PreserveState> state =
            last_sound_snapshot(database, saved, path, kinds, opened.warnings);
        if (!state) return state.error();
        Result<SettingsPtr> laws =
            laws_at(saved.origin.settings, saved.interventions, state->tick, kinds);
        if (!laws) return preserve_failure(kOpeningPreserve, path, laws.error().message);
        database.make_durable();
        auto parts = std::make_unique<Parts>(path, std::move(*lock), std::move(database), kinds);
        opened.laws = *std::move(laws);
        opened.origin = std::move(saved.origin);
        opened.state = *std::move(state);
        Transaction transaction(parts->database);
        parts->writer.remove_after(opened.state);
        transaction.commit();
        opened.series = read_series(parts->database);
        opened.museum = read_museum(parts->database, kinds);
        const std::optional<Pins> pins = read_pins(parts->database);
        if (!pins) opened.warnings.emplace_back("its pins are damaged, and forgotten");
        opened.pins = pins.value_or(Pins());
        opened.file.reset(new PreserveFile(std::move(parts)));
        return opened;
    } catch (const DatabaseError& error) {
        return preserve_failure(kOpeningPreserve, path, error.what());
    }
}

// Carries out a change of the tables, or nothing of it.
Status PreserveFile::change(const std::function<void()>& rows) {
    if (!parts_->lock.in_place())
        return preserve_failure(kKeepingPreserve, parts_->path,
                                "it was removed or replaced meanwhile");
    try {
        Transaction transaction(parts_->database);
        rows();
        transaction.commit();
    } catch (const DatabaseError& error) {
        return preserve_failure(kKeepingPreserve, parts_->path, error.what());
    }
    return {};
}

Status PreserveFile::write(const Chronicle& chronicle, const Preserve& preserve) {
    return change([&] {
        parts_->writer.write(chronicle, preserve);
        snapshots_ = read_snapshot_ticks(parts_->database);
    });
}

Status PreserveFile::keep_pins(const Pins& pins) {
    return change([&] { parts_->writer.put_pins(pins); });
}

}  // namespace cambrian
