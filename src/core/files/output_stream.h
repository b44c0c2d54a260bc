#pragma once

// Writes results piece by piece to standard output, a file, a FIFO or a device. Every write and the
// end are checked.

#include "core/files/file_descriptor.h"
#include "core/files/pending_file.h"
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
    // A regular file appears only with finish(), complete. An open file of this process
    // ("/dev/stdout", "/dev/fd/3"), a FIFO or a device gets each piece at once.
    static Result<OutputStream> open(const std::filesystem::path& path);

    // Writes all of the bytes. The error message names the output.
    Status write(std::string_view bytes);
    // Flushes the output. Must be the last call.
    Status finish();

private:
    explicit OutputStream(std::string name) : name_(std::move(name)) {}

    std::string name_;  // for messages
    std::optional<PendingFile> file_;
    FileDescriptor opened_;
    int descriptor_ = -1;  // descriptor to write to, unless the output is a regular file
};

}  // namespace cambrian
