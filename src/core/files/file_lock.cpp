#include "core/files/file_lock.h"

#include "core/files/file_identity.h"

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <mutex>
#include <optional>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <utility>

namespace cambrian {
namespace {

constexpr const char* kInUse = "it is open in another window or program";

// Another program that checks whether the file is free holds the lock only briefly.
constexpr int kAttempts = 10;
constexpr auto kPause = std::chrono::milliseconds(20);

// Locks the file after a few attempts; returns 0 or the error code.
int lock_soon(int file, int operation) {
    for (int attempt = 1; ::flock(file, operation | LOCK_NB) != 0; ++attempt) {
        if (errno != EWOULDBLOCK || attempt == kAttempts) return errno;
        std::this_thread::sleep_for(kPause);
    }
    return 0;
}

// The files that this process has locked.
struct OwnLocks {
    std::mutex mutex;
    std::set<FileIdentity> files;
};

OwnLocks& own_locks() {
    static OwnLocks locks;
    return locks;
}

// Returns nothing if the file is free. The mutex of the own locks must be held.
std::optional<Error> refusal(const std::filesystem::path& path) {
    struct stat facts {};
    if (::stat(path.c_str(), &facts) != 0) return Error{std::generic_category().message(errno)};
    if (!S_ISREG(facts.st_mode)) return Error{"it is not a regular file"};
    if (own_locks().files.contains(identity_of(facts))) return Error{kInUse};
    return std::nullopt;
}

}  // namespace

Result<FileLock> FileLock::take(const std::filesystem::path& path) {
    OwnLocks& own = own_locks();
    const std::lock_guard guard(own.mutex);
    if (auto refused = refusal(path)) return *refused;
    // Prevents waiting for the other end if the file has become a FIFO.
    FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (!file.is_open()) return Error{std::generic_category().message(errno)};
    if (const int failure = lock_soon(file.get(), LOCK_EX); failure != 0) {
        return Error{failure == EWOULDBLOCK ? kInUse : std::generic_category().message(failure)};
    }
    struct stat facts {};
    if (::fstat(file.get(), &facts) == 0) own.files.insert(identity_of(facts));
    return FileLock(std::move(file), path);
}

Status FileLock::check_free(const std::filesystem::path& path) {
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown)) return {};
    const std::lock_guard guard(own_locks().mutex);
    if (auto refused = refusal(path)) return *refused;
    const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    // A file that cannot be read is not locked by this program.
    if (!file.is_open() || lock_soon(file.get(), LOCK_SH) != EWOULDBLOCK) return {};
    return Error{kInUse};
}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(path_, other.path_);
    return *this;
}

FileLock::~FileLock() {
    if (!file_.is_open()) return;
    OwnLocks& own = own_locks();
    const std::lock_guard guard(own.mutex);
    struct stat facts {};
    if (::fstat(file_.get(), &facts) == 0) own.files.erase(identity_of(facts));
    file_.close();
}

bool FileLock::in_place() const {
    if (!file_.is_open()) return true;
    struct stat held {};
    struct stat named {};
    return ::fstat(file_.get(), &held) == 0 && ::stat(path_.c_str(), &named) == 0 &&
           identity_of(held) == identity_of(named);
}

}  // namespace cambrian
