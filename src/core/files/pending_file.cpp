#include "core/files/pending_file.h"

#include "core/files/database_companions.h"
#include "core/files/file_errors.h"
#include "core/files/file_lock.h"
#include "core/files/leftovers.h"
#include "core/files/output_target.h"
#include "core/text/parsed_number.h"

#include <fmt/core.h>

#include <cerrno>
#include <fcntl.h>
#include <mutex>
#include <string>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace cambrian {
namespace {

constexpr std::string_view kPrefix = ".cambrian-";

void remove_with_companions(const std::filesystem::path& file) {
    ::unlink(file.c_str());
    remove_companions(file);
}

// Returns the process that made a temporary file, ".cambrian-PID-N", or a companion of one that is
// not there; 0 for other names.
pid_t maker_of(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    const TemporaryName parts = temporary_name(name, kPrefix);
    if (parsed_number<unsigned>(parts.rest)) return parts.maker;
    for (const std::string_view ending : kDatabaseCompanions) {
        if (!name.ends_with(ending)) continue;
        const auto file = path.parent_path() / name.substr(0, name.size() - ending.size());
        std::error_code unknown;
        return std::filesystem::exists(file, unknown) ? 0 : maker_of(file);
    }
    return 0;
}

void remove_stale(const std::filesystem::path& folder) {
    std::error_code unreadable;
    std::filesystem::directory_iterator entry(folder.empty() ? "." : folder, unreadable);
    for (; !unreadable && entry != std::filesystem::directory_iterator();
         entry.increment(unreadable)) {
        if (is_leftover(entry->path(), maker_of(entry->path())))
            remove_with_companions(entry->path());
    }
}

struct NewFile {
    std::filesystem::path path;
    FileDescriptor file;  // closed if the file could not be made; errno has the reason
};

// The name is short, so that it is valid beside any other, and unique.
NewFile make_beside(const std::filesystem::path& target, mode_t mode) {
    static std::mutex one_at_a_time;  // a new file counts as stale until it is locked
    static unsigned count = 0;
    const std::lock_guard lock(one_at_a_time);
    remove_stale(target.parent_path());
    const std::string start = fmt::format("{}{}-", kPrefix, ::getpid());
    NewFile made;
    do {
        made.path = target.parent_path() / fmt::format("{}{}", start, ++count);
        made.file =
            FileDescriptor(::open(made.path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    } while (!made.file.is_open() && errno == EEXIST);
    if (made.file.is_open()) ::flock(made.file.get(), LOCK_EX | LOCK_NB);
    return made;
}

// Copies the permissions as far as this process may.
void adopt_permissions(int file, const std::filesystem::path& from) {
    struct stat facts {};
    if (::stat(from.c_str(), &facts) != 0) return;
    if (::fchown(file, facts.st_uid, facts.st_gid) != 0 &&
        ::fchown(file, static_cast<uid_t>(-1), facts.st_gid) != 0)
        facts.st_mode &= static_cast<mode_t>(~S_IRWXG);
    ::fchmod(file, facts.st_mode & 0777);
}

int rename_over(const std::filesystem::path& temporary, const std::filesystem::path& target) {
    return ::rename(temporary.c_str(), target.c_str()) == 0 ? 0 : errno;
}

int rename_to_new(const std::filesystem::path& temporary, const std::filesystem::path& target) {
    if (::renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0)
        return 0;
    if (errno != EINVAL && errno != ENOSYS) return errno;
    // Some file systems support only the plain call.
    std::error_code unknown;
    return std::filesystem::exists(target, unknown) ? EEXIST : rename_over(temporary, target);
}

}  // namespace

Result<PendingFile> PendingFile::beside(const std::filesystem::path& target) {
    const Result<OutputTarget> facts = output_target(target);
    if (!facts) return facts.error();
    if (facts->kind == OutputTarget::Kind::kFolder) return write_outcome(target, EISDIR).error();
    if (facts->kind != OutputTarget::Kind::kFile) return cannot_write(target, "not a regular file");
    if (const Status free = FileLock::check_free(facts->path); !free)
        return cannot_write(target, free.error().message);
    struct stat replaced {};
    const bool exists = ::stat(facts->path.c_str(), &replaced) == 0;
    // The file must never be readable by more people than the one it replaces.
    const mode_t mode = exists ? (replaced.st_mode & 0777) | S_IRUSR | S_IWUSR : 0666;
    NewFile made = make_beside(facts->path, mode);
    if (!made.file.is_open()) return write_outcome(target, errno).error();
    return PendingFile(facts->path, std::move(made.path), std::move(made.file));
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      file_(std::move(other.file_)) {}

PendingFile::~PendingFile() {
    if (!temporary_.empty()) remove_with_companions(temporary_);
}

int PendingFile::put_in_place(Existing existing) {
    adopt_permissions(file_.get(), target_);
    if (::fsync(file_.get()) != 0) return errno;
    if (const int failure = file_.close(); failure != 0) return failure;
    return existing == Existing::kReplace ? rename_over(temporary_, target_)
                                          : rename_to_new(temporary_, target_);
}

Status PendingFile::commit(Existing existing) {
    if (has_unwritten_changes(temporary_))
        return cannot_write(target_,
                            "its last changes cannot be written into it; the disk is full");
    remove_companions(temporary_);
    const int failure = put_in_place(existing);
    if (failure == 0) temporary_.clear();
    return write_outcome(target_, failure);
}

}  // namespace cambrian
