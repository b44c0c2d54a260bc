#include "core/file_io.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace cambrian {
namespace {

std::string system_message(int code) {
    return std::generic_category().message(code);
}

std::string megabytes(double bytes) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f MB", bytes / 1e6);
    return text;
}

// Closes on scope exit.
class FileDescriptor {
public:
    explicit FileDescriptor(int value) : value_(value) {}
    ~FileDescriptor() {
        if (value_ >= 0) ::close(value_);
    }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    int get() const { return value_; }
    // The error code of closing, 0 if none.
    int close() {
        const int result = ::close(value_);
        value_ = -1;
        return result == 0 ? 0 : errno;
    }

private:
    int value_;
};

// 0, or the error code.
int write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

int write_new_file(const std::string& path, std::string_view bytes) {
    FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644));
    if (file.get() < 0) return errno;
    if (const int failure = write_all(file.get(), bytes); failure != 0) return failure;
    return ::fsync(file.get()) == 0 ? file.close() : errno;
}

// A terminal, a pipe, /dev/null: holds nothing that could be lost, and must not be renamed over.
int write_device(const std::string& path, std::string_view bytes) {
    FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.get() < 0) return errno;
    const int failure = write_all(file.get(), bytes);
    return failure != 0 ? failure : file.close();
}

int replace_file(const std::filesystem::path& target, std::string_view bytes) {
    const std::string temporary = temporary_beside(target).string();
    int failure = write_new_file(temporary, bytes);
    if (failure == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) failure = errno;
    if (failure != 0) ::unlink(temporary.c_str());
    return failure;
}

// What a path stands for: links followed, and whether it is written to as it is.
struct Target {
    std::filesystem::path path;
    bool device = false;
    bool folder = false;
};

Target target_of(const std::filesystem::path& path) {
    std::error_code unresolved;
    Target target{.path = std::filesystem::canonical(path, unresolved)};
    if (unresolved) target.path = path;  // not there yet
    struct stat facts {};
    if (::stat(target.path.c_str(), &facts) != 0) return target;
    target.folder = S_ISDIR(facts.st_mode);
    target.device = !target.folder && !S_ISREG(facts.st_mode);
    return target;
}

Status outcome(int failure, const std::filesystem::path& path) {
    if (failure == 0) return {};
    return Error{"cannot write " + path.string() + ": " + system_message(failure)};
}

int open_to_read(const std::filesystem::path& path) {
    return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

// Right after opening; fails if that did.
Result<std::size_t> size_of(const FileDescriptor& file, const std::filesystem::path& path) {
    if (file.get() < 0) return Error{"cannot open " + path.string() + ": " + system_message(errno)};
    struct stat facts {};
    if (::fstat(file.get(), &facts) != 0 || !S_ISREG(facts.st_mode)) {
        return Error{path.string() + " is not a regular file"};
    }
    return static_cast<std::size_t>(facts.st_size);
}

// From the start, as many as there are.
Result<std::string> read_bytes(const FileDescriptor& file, std::size_t count,
                               const std::filesystem::path& path) {
    std::string bytes(count, '\0');
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t got = ::read(file.get(), bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return Error{"cannot read " + path.string() + ": " + system_message(errno)};
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    bytes.resize(filled);
    return bytes;
}

int flush_file(const std::string& path) {
    FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.get() < 0) return errno;
    return ::fsync(file.get()) == 0 ? file.close() : errno;
}

template <class Rename>  // gives 0 or the error code
Status move_flushed(const std::filesystem::path& temporary, const std::filesystem::path& target,
                    Rename rename) {
    int failure = flush_file(temporary.string());
    if (failure == 0) failure = rename();
    if (failure != 0) ::unlink(temporary.c_str());
    return outcome(failure, target);
}

int rename_over(const std::filesystem::path& temporary, const std::filesystem::path& target) {
    return ::rename(temporary.c_str(), target.c_str()) == 0 ? 0 : errno;
}

int rename_to_new(const std::filesystem::path& temporary, const std::filesystem::path& target) {
    if (::renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0)
        return 0;
    if (errno != EINVAL && errno != ENOSYS) return errno;
    // A file system that has only the plain call.
    std::error_code unknown;
    return std::filesystem::exists(target, unknown) ? EEXIST : rename_over(temporary, target);
}

}  // namespace

// Short, so that it is a possible name beside any other, and not shared with another thread.
std::filesystem::path temporary_beside(const std::filesystem::path& target) {
    static std::atomic<unsigned> count = 0;
    return target.parent_path() /
           (".cambrian-" + std::to_string(::getpid()) + "-" + std::to_string(++count));
}

Status move_into_place(const std::filesystem::path& temporary,
                       const std::filesystem::path& target) {
    return move_flushed(temporary, target, [&] { return rename_over(temporary, target); });
}

Status move_to_new(const std::filesystem::path& temporary, const std::filesystem::path& target) {
    return move_flushed(temporary, target, [&] { return rename_to_new(temporary, target); });
}

Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes) {
    const FileDescriptor file(open_to_read(path));
    const Result<std::size_t> size = size_of(file, path);
    if (!size) return size.error();
    if (*size > max_bytes) {
        return Error{path.string() + ": file too large: " + megabytes(static_cast<double>(*size)) +
                     ", limit " + megabytes(static_cast<double>(max_bytes))};
    }
    return read_bytes(file, *size, path);
}

Result<std::string> read_start(const std::filesystem::path& path, std::size_t most) {
    const FileDescriptor file(open_to_read(path));
    const Result<std::size_t> size = size_of(file, path);
    if (!size) return size.error();
    return read_bytes(file, std::min(*size, most), path);
}

Status write_file(const std::filesystem::path& path, std::string_view bytes) {
    const Target target = target_of(path);
    return outcome(
        target.device ? write_device(target.path, bytes) : replace_file(target.path, bytes), path);
}

Result<PendingFile> PendingFile::beside(const std::filesystem::path& target) {
    if (const Status writable = check_writable(target); !writable) return writable.error();
    const Target facts = target_of(target);
    if (facts.device) return Error{"cannot write " + target.string() + ": not a regular file"};
    return PendingFile(facts.path);
}

PendingFile::PendingFile(std::filesystem::path target)
    : target_(std::move(target)), temporary_(temporary_beside(target_)) {}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : target_(std::move(other.target_)), temporary_(std::exchange(other.temporary_, {})) {}

PendingFile::~PendingFile() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Status PendingFile::commit() {
    return move_into_place(std::exchange(temporary_, {}), target_);
}

Status check_writable(const std::filesystem::path& path) {
    const Target target = target_of(path);
    if (target.folder) return outcome(EISDIR, path);
    if (target.device) return outcome(::access(target.path.c_str(), W_OK) == 0 ? 0 : errno, path);
    const std::filesystem::path trial = temporary_beside(target.path);
    const int failure = write_new_file(trial, "");
    if (failure == 0) ::unlink(trial.c_str());
    return outcome(failure, path);
}

}  // namespace cambrian
