#pragma once

// The kind of output that a path leads to. Files are replaced completely; anything else that
// accepts bytes is a stream and is never replaced.

#include "core/result.h"

#include <filesystem>

namespace cambrian {

struct OutputTarget {
    enum class Kind : unsigned char {
        kFile,        // a regular file, or nothing yet
        kFolder,      //
        kStream,      // a FIFO or a character device, opened under its name
        kDescriptor,  // an open file of this process: /dev/stdout, /dev/fd/3
    };

    std::filesystem::path path;  // with all links followed
    Kind kind = Kind::kFile;
    int descriptor = -1;
};

// Follows links, including one to a file that does not exist. Fails for anything that cannot be an
// output: a disk, a socket, an open file of another process, a cycle of links.
Result<OutputTarget> output_target(const std::filesystem::path& path);

}  // namespace cambrian
