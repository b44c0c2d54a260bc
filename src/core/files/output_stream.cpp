#include "core/files/output_stream.h"

#include "core/files/file_errors.h"
#include "core/files/output_target.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace cambrian {

OutputStream OutputStream::standard_output() {
    OutputStream stream("to standard output");
    stream.descriptor_ = STDOUT_FILENO;
    return stream;
}

Result<OutputStream> OutputStream::open(const std::filesystem::path& path) {
    const Result<OutputTarget> target = output_target(path);
    if (!target) return target.error();
    OutputStream stream(path.string());
    if (target->kind == OutputTarget::Kind::kDescriptor) {
        stream.descriptor_ = target->descriptor;
    } else if (target->kind == OutputTarget::Kind::kStream) {
        stream.opened_ = FileDescriptor(::open(target->path.c_str(), O_WRONLY | O_CLOEXEC));
        if (!stream.opened_.is_open()) return write_outcome(stream.name_, errno).error();
        stream.descriptor_ = stream.opened_.get();
    } else {
        Result<PendingFile> file = PendingFile::beside(path);
        if (!file) return file.error();
        stream.file_.emplace(std::move(*file));
    }
    return stream;
}

Status OutputStream::write(std::string_view bytes) {
    return write_outcome(name_, file_ ? file_->write(bytes) : write_all(descriptor_, bytes));
}

Status OutputStream::finish() {
    if (file_) return file_->commit();
    if (opened_.is_open()) return write_outcome(name_, opened_.close());
    // Some file systems report a failure only when a file is closed.
    FileDescriptor again(::fcntl(descriptor_, F_DUPFD_CLOEXEC, 0));
    return write_outcome(name_, again.is_open() ? again.close() : errno);
}

}  // namespace cambrian
