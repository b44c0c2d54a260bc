#pragma once

// Where results go, piece by piece: standard output, a file, a FIFO or a device. Every piece and
// the end are checked.

#include "core/file_descriptor.h"
#include "core/pending_file.h"
#include "core/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace cambrian {

class OutputStream {
public:
    static OutputStream standard_output();
    // A regular file comes to be whole with finish() and not before; an open file of this process
    // ("/dev/stdout", "/dev/fd/3"), a FIFO or a device takes each piece at once.
    static Result<OutputStream> open(const std::filesystem::path& path);

    // All of the bytes. The message of a failure names the output.
    Status write(std::string_view bytes);
    // Flushes. Nothing may be written after it.
    Status finish();

private:
    explicit OutputStream(std::string name) : name_(std::move(name)) {}

    std::string name_;  // for messages
    std::optional<PendingFile> file_;
    FileDescriptor opened_;
    int descriptor_ = -1;  // that is written to, unless it is a file
};

}  // namespace cambrian
