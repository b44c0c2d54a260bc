#include "persist/file_lock.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace cambrian {

Result<FileLock> FileLock::take(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return Error{std::generic_category().message(errno)};
    FileLock lock(file, path);
    if (::flock(file, LOCK_EX | LOCK_NB) != 0)
        return Error{"it is open in another window or program"};
    return lock;
}

Status FileLock::check_free(const std::filesystem::path& path) {
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown)) return {};
    const Result<FileLock> lock = take(path);
    return lock ? Status() : Status(lock.error());
}

FileLock::FileLock(FileLock&& other) noexcept
    : file_(std::exchange(other.file_, -1)), path_(std::move(other.path_)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(path_, other.path_);
    return *this;
}

FileLock::~FileLock() {
    if (file_ >= 0) ::close(file_);
}

bool FileLock::in_place() const {
    if (file_ < 0) return true;
    struct stat held {};
    struct stat named {};
    return ::fstat(file_, &held) == 0 && ::stat(path_.c_str(), &named) == 0 &&
           held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

}  // namespace cambrian
