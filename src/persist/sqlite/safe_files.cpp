#include "persist/sqlite/safe_files.h"

#include "core/files/file_descriptor.h"
#include "core/text/shown_text.h"
#include "persist/sqlite/database.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fcntl.h>
#include <sqlite3.h>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>

namespace cambrian {
namespace {

// The end of a journal that names a super-journal: the length of the name and its check in 4 bytes
// each, and these 8 (SQLite's file format, 3.).
constexpr std::string_view kJournalMark = "\xd9\xd5\x05\xf9\x20\xa1\x63\xd7";
constexpr off_t kTrailer = 16;  // bytes
constexpr off_t kLongestShown = 200;

// Returns the bytes of a file from `begin` to `end`.
std::string bytes_between(const FileDescriptor& file, off_t begin, off_t end) {
    std::string bytes(static_cast<std::size_t>(end - begin), '\0');
    const ssize_t got = ::pread(file.get(), bytes.data(), bytes.size(), begin);
    bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
    return bytes;
}

off_t big_endian(std::string_view bytes) {
    off_t number = 0;
    for (const char byte : bytes)
        number = 256 * number + static_cast<std::uint8_t>(byte);
    return number;
}

const sqlite3_vfs& system_files() {
    static const sqlite3_vfs& files = *sqlite3_vfs_find(nullptr);
    return files;
}

int open_unless_super(sqlite3_vfs* files, const char* name, sqlite3_file* file, int flags,
                      int* flags_out) {
    if ((flags & SQLITE_OPEN_SUPER_JOURNAL) == 0)
        return system_files().xOpen(files, name, file, flags, flags_out);
    file->pMethods = nullptr;
    return SQLITE_CANTOPEN;
}

sqlite3_vfs without_super_journals() {
    sqlite3_vfs files = system_files();
    files.pNext = nullptr;
    files.zName = "without super-journals";
    files.xOpen = open_unless_super;
    return files;
}

}  // namespace

void check_journal(const std::filesystem::path& database) {
    std::error_code missing;
    // SQLite's files are beside the target of a link.
    std::filesystem::path path = std::filesystem::canonical(database, missing);
    if (missing) path = database;
    path += "-journal";
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    struct stat facts {};
    if (!file.is_open() || ::fstat(file.get(), &facts) != 0 || facts.st_size < kTrailer) return;
    const off_t end = facts.st_size - kTrailer;
    const std::string trailer = bytes_between(file, end, facts.st_size);
    if (!trailer.ends_with(kJournalMark)) return;
    const off_t length = std::min(big_endian(trailer.substr(0, 4)), end);
    const std::string name = bytes_between(file, end - length, std::min(end, end - length + 999));
    throw DatabaseError(fmt::format(
        "its rollback journal names {}, which SQLite would delete; remove {} if you do not know "
        "where it comes from",
        in_quotes(name, kLongestShown), path.filename().string()));
}

const char* safe_file_system() {
    static sqlite3_vfs files = without_super_journals();
    static const int registered = sqlite3_vfs_register(&files, 0);
    if (registered != SQLITE_OK) throw DatabaseError("SQLite has no file system");
    return files.zName;
}

}  // namespace cambrian
