#include "core/files/file_io.h"

#include "core/files/file_descriptor.h"
#include "core/files/file_errors.h"
#include "core/files/output_stream.h"
#include "core/files/output_target.h"
#include "core/files/pending_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <cerrno>
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
    return fmt::format("{:.1f} MB", bytes / 1e6);
}

int open_to_read(const std::filesystem::path& path) {
    return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
}

// Must be called right after opening; fails if opening failed.
Result<std::size_t> size_of(const FileDescriptor& file, const std::filesystem::path& path) {
    if (file.get() < 0)
        return Error{fmt::format("cannot open {}: {}", path.string(), system_message(errno))};
    struct stat facts {};
    if (::fstat(file.get(), &facts) != 0 || !S_ISREG(facts.st_mode)) {
        return Error{path.string() + " is not a regular file"};
    }
    return static_cast<std::size_t>(facts.st_size);
}

// Reads up to `count` bytes from the start.
Result<std::string> read_bytes(const FileDescriptor& file, std::size_t count,
                               const std::filesystem::path& path) {
    std::string bytes(count, '\0');
    std::size_t filled = 0;
    while (filled < bytes.size()) {
        const ssize_t got = ::read(file.get(), bytes.data() + filled, bytes.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0)
            return Error{fmt::format("cannot read {}: {}", path.string(), system_message(errno))};
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    bytes.resize(filled);
    return bytes;
}

}  // namespace

Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes) {
    const FileDescriptor file(open_to_read(path));
    const Result<std::size_t> size = size_of(file, path);
    if (!size) return size.error();
    if (*size > max_bytes) {
        return Error{fmt::format("{}: file too large: {}, limit {}", path.string(),
                                 megabytes(static_cast<double>(*size)),
                                 megabytes(static_cast<double>(max_bytes)))};
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
    Result<OutputStream> stream = OutputStream::open(path);
    if (!stream) return stream.error();
    if (Status written = stream->write(bytes); !written) return written;
    return stream->finish();
}

Status check_writable(const std::filesystem::path& path) {
    const Result<OutputTarget> target = output_target(path);
    if (!target) return target.error();
    if (target->kind == OutputTarget::Kind::kDescriptor) {
        const int access = ::fcntl(target->descriptor, F_GETFL) & O_ACCMODE;
        return write_outcome(path, access == O_RDONLY ? EBADF : 0);
    }
    if (target->kind == OutputTarget::Kind::kStream)
        return write_outcome(path, ::access(target->path.c_str(), W_OK) == 0 ? 0 : errno);
    const Result<PendingFile> trial = PendingFile::beside(path);
    return trial ? Status() : Status(trial.error());
}

}  // namespace cambrian
