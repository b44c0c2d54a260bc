#include "persist/experiment/experiment_file.h"

#include "core/files/database_companions.h"
#include "core/files/file_io.h"
#include "core/files/file_lock.h"
#include "core/files/pending_file.h"
#include "persist/experiment/experiment_loading.h"
#include "persist/experiment/experiment_reader.h"
#include "persist/experiment/experiment_upgrade.h"
#include "persist/experiment/experiment_writer.h"
#include "persist/records/experiment_schema.h"

#include <fmt/core.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace cambrian {
namespace {

Error failure(const char* task, const std::filesystem::path& path, const std::string& reason) {
    const std::string place = path.empty() ? "a temporary file" : path.string();
    return Error{fmt::format("{} {}: {}", task, place, reason)};
}

constexpr const char* kKeeping = "cannot keep the experiment in";
constexpr const char* kOpening = "cannot open";

}  // namespace

// An open file. The lock outlives the connection, because closing any descriptor of a file releases
// SQLite's own locks on it.
struct ExperimentFile::Open {
    Open(std::filesystem::path name, FileLock held, Database database, const EvolutionKinds& kinds)
        : path(std::move(name)), lock(std::move(held)), writer(std::move(database), kinds) {}

    std::filesystem::path path;
    FileLock lock;
    ExperimentWriter writer;
};

ExperimentFile::ExperimentFile(std::unique_ptr<Open> open, const EvolutionKinds& kinds)
    : kinds_(kinds), open_(std::move(open)) {}

ExperimentFile::~ExperimentFile() = default;

Result<std::shared_ptr<ExperimentFile>> ExperimentFile::create(
    const EvolutionKinds& kinds, const SettingsPtr& settings,
    const std::vector<GenomePtr>& founders) {
    try {
        Database database({}, Database::Access::kCreate);
        create_tables(database);
        auto open =
            std::make_unique<Open>(std::filesystem::path(), FileLock(), std::move(database), kinds);
        open->writer.begin(settings, founders);
        return std::shared_ptr<ExperimentFile>(new ExperimentFile(std::move(open), kinds));
    } catch (const DatabaseError& error) {
        return failure(kKeeping, {}, error.what());
    }
}

template <class Write>
Status ExperimentFile::write(Write write) {
    const std::lock_guard guard(mutex_);
    if (!open_->lock.in_place()) {
        return failure(kKeeping, open_->path,
                       "it was removed or replaced meanwhile; save the experiment elsewhere");
    }
    try {
        write(open_->writer);
    } catch (const DatabaseError& error) {
        return failure(kKeeping, open_->path, error.what());
    }
    return {};
}

Status ExperimentFile::note(const NotedCommand& command) {
    return write([&](ExperimentWriter& writer) { writer.note(command); });
}

Status ExperimentFile::record(const Evolution& evolution) {
    return write([&](ExperimentWriter& writer) { writer.record(evolution); });
}

Status ExperimentFile::crown(const JudgedIndividual& champion) {
    return write([&](ExperimentWriter& writer) { writer.crown(champion); });
}

Status ExperimentFile::keep_picking(const PickingRecord& picking) {
    return write([&](ExperimentWriter& writer) { writer.keep_picking(picking); });
}

Status ExperimentFile::keep_stars(const std::vector<JudgedIndividual>& stars) {
    return write([&](ExperimentWriter& writer) { writer.keep_stars(stars); });
}

// The new file already has the write-ahead log of a file in use, so a crash never leaves one
// without it.
Status ExperimentFile::copy_into(const std::filesystem::path& temporary) const {
    try {
        open_->writer.copy_to(temporary);
        Database(temporary, Database::Access::kWrite).make_durable();
        return {};
    } catch (const DatabaseError& error) {
        return Error{error.what()};
    }
}

Status ExperimentFile::move_to(const std::filesystem::path& path, Existing existing) {
    const std::lock_guard guard(mutex_);
    std::error_code other;
    if (!open_->path.empty() && open_->lock.in_place() &&
        std::filesystem::equivalent(path, open_->path, other))
        return {};
    if (Status free = FileLock::check_free(path); !free)
        return failure(kKeeping, path, free.error().message);
    if (existing == Existing::kRefuse && std::filesystem::exists(path, other))
        return failure(kKeeping, path, std::generic_category().message(EEXIST));
    Result<PendingFile> file = PendingFile::beside(path);
    if (!file) return file.error();
    if (Status copied = copy_into(file->path()); !copied)
        return failure(kKeeping, path, copied.error().message);
    remove_companions(file->target());
    if (Status moved = file->commit(existing); !moved) return moved;
    Status kept = go_on_in(path);
    if (!kept && existing == Existing::kRefuse) std::filesystem::remove(path, other);
    return kept;
}

Status ExperimentFile::go_on_in(const std::filesystem::path& path) {
    Result<FileLock> lock = FileLock::take(path);
    if (!lock) return failure(kKeeping, path, lock.error().message);
    try {
        Database database(path, Database::Access::kWrite);
        database.make_durable();
        auto open = std::make_unique<Open>(path, std::move(*lock), std::move(database), kinds_);
        open->writer.remember(open_->writer);
        open_ = std::move(open);
        return {};
    } catch (const DatabaseError& error) {
        return failure(kKeeping, path, error.what());
    }
}

std::filesystem::path ExperimentFile::path() const {
    const std::lock_guard guard(mutex_);
    return open_->path;
}

Result<OpenedExperiment> open_experiment(const std::filesystem::path& path,
                                         const EvolutionKinds& kinds) {
    // SQLite needs to write the file and others beside it. This check would fail under the lock.
    if (Status writable = check_writable(path); !writable) return writable.error();
    Result<FileLock> lock = FileLock::take(path);
    if (!lock) return failure(kOpening, path, lock.error().message);
    try {
        Database database(path, Database::Access::kWrite);
        Transaction transaction(database);
        if (Status current = bring_up_to_date(database); !current)
            return failure(kOpening, path, current.error().message);
        ReadExperiment read = read_experiment(database, kinds);
        transaction.commit();
        database.make_durable();
        auto open = std::make_unique<ExperimentFile::Open>(path, std::move(*lock),
                                                           std::move(database), kinds);
        open->writer.remember(read);
        return OpenedExperiment{
            std::shared_ptr<ExperimentFile>(new ExperimentFile(std::move(open), kinds)),
            std::move(read.saved), std::move(read.picking), std::move(read.stars)};
    } catch (const DatabaseError& error) {
        return failure(kOpening, path, error.what());
    }
}

Result<SavedExperiment> load_experiment(const std::filesystem::path& path,
                                        const EvolutionKinds& kinds) {
    return load_from_experiment<SavedExperiment>(
        path, [&](const Database& database) -> Result<SavedExperiment> {
            return read_experiment(database, kinds).saved;
        });
}

}  // namespace cambrian
