#include "persist/sqlite/read_only_database.h"

#include "core/files/private_folder.h"
#include "persist/sqlite/safe_files.h"

#include <fmt/core.h>

#include <cerrno>
#include <cstdint>
#include <sys/stat.h>
#include <system_error>

namespace cambrian {
namespace {

namespace fs = std::filesystem;

constexpr int kMostAttempts = 5;
constexpr std::uintmax_t kMostChanges = 512'000'000;  // bytes of a log or journal

// The identity and last change of a file; all 0 if there is none.
struct FileFacts {
    ino_t inode = 0;
    off_t size = 0;
    timespec changed{};

    bool operator==(const FileFacts& other) const {
        return inode == other.inode && size == other.size &&
               changed.tv_sec == other.changed.tv_sec && changed.tv_nsec == other.changed.tv_nsec;
    }
};

FileFacts facts_of(const fs::path& path) {
    struct stat facts {};
    if (::stat(path.c_str(), &facts) != 0) return {};
    return {facts.st_ino, facts.st_size, facts.st_mtim};
}

fs::path beside(const fs::path& path, const char* ending) {
    return path.string() + ending;
}

// The state of a database file and of SQLite's files beside it.
struct FilesOfDatabase {
    FileFacts file;
    FileFacts log;        // changes that are not in the file yet
    FileFacts journal;    // data to undo a change that was interrupted
    bool shared = false;  // whether the index that readers of the log share exists

    explicit FilesOfDatabase(const fs::path& path)
        : file(facts_of(path)),
          log(facts_of(beside(path, "-wal"))),
          journal(facts_of(beside(path, "-journal"))),
          shared(facts_of(beside(path, "-shm")).inode != 0) {}

    bool operator==(const FilesOfDatabase& other) const {
        return file == other.file && log == other.log && journal == other.journal;
    }
    bool alone() const { return log.size == 0 && journal.size == 0; }
    bool in_use() const { return log.size > 0 && journal.size == 0 && shared; }
};

std::string no_room() {
    return of_temporary_folder(std::generic_category().message(ENOSPC));
}

// Copies a file of this user to the temporary folder.
void copy_if_there(const fs::path& from, const fs::path& to) {
    std::error_code failure;
    if (!fs::exists(from, failure)) return;
    if (fs::space(to.parent_path(), failure).available < fs::file_size(from, failure))
        throw DatabaseError(no_room());
    if (!fs::copy_file(from, to, failure)) throw DatabaseError(failure.message());
    fs::permissions(to, fs::perms::owner_read | fs::perms::owner_write, failure);
}

// SQLite's own programs keep the log at a few megabytes.
void check_companion(const fs::path& companion) {
    std::error_code missing;
    const std::uintmax_t size = fs::file_size(companion, missing);
    if (missing || size <= kMostChanges) return;
    throw DatabaseError(fmt::format(
        "{} beside it has {} MB, at most {} MB are read without write access; what continues the "
        "file takes them in",
        companion.filename().string(), size / 1'000'000, kMostChanges / 1'000'000));
}

// Opens a copy in the state that SQLite's recovery after a crash gives.
Database recovered(const fs::path& path) {
    check_journal(path);
    for (const char* ending : {"-wal", "-journal"})
        check_companion(beside(path, ending));
    const Result<PrivateFolder> folder = PrivateFolder::make();
    if (!folder) throw DatabaseError("it has to be copied to " + folder.error().message);
    const fs::path copy = folder->path() / "copy";
    for (const char* ending : {"", "-wal", "-journal"})
        copy_if_there(beside(path, ending), beside(copy, ending));
    try {
        Database database(copy, Database::Access::kWrite);
        database.execute("PRAGMA locking_mode = EXCLUSIVE");  // needs no further file
        return database.copy();
    } catch (const DiskFullError&) {
        throw DatabaseError(no_room());
    }
}

Database open_as_it_is(const fs::path& path, const FilesOfDatabase& files) {
    if (files.alone()) return {path, Database::Access::kReadUnchanging};
    if (!files.in_use()) return recovered(path);
    try {
        Database database(path, Database::Access::kRead);
        database.integer("PRAGMA schema_version");
        return database;
    } catch (const DatabaseError&) {
        return recovered(path);
    }
}

}  // namespace

void read_database(const fs::path& named, const std::function<void(const Database&)>& read) {
    std::error_code missing;
    // SQLite's files are beside the target of a link.
    fs::path path = fs::canonical(named, missing);
    if (missing) path = named;
    for (int attempt = 1;; ++attempt) {
        const FilesOfDatabase before(path);
        const bool last = attempt == kMostAttempts;
        try {
            read(open_as_it_is(path, before));
            if (before.in_use() || FilesOfDatabase(path) == before) return;
        } catch (const DatabaseError&) {
            if (last || FilesOfDatabase(path) == before) throw;
        }
        if (last) throw DatabaseError("another program is using it");
    }
}

}  // namespace cambrian
