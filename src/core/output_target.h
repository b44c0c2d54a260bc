#pragma once

// What a path that is named as an output leads to. Files are replaced as a whole; whatever else
// can take bytes is a stream and is never replaced.

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

    std::filesystem::path path;  // links followed
    Kind kind = Kind::kFile;
    int descriptor = -1;
};

// Follows links, also one that leads to nothing yet. Fails for what cannot be an output: a disk, a
// socket, an open file of another process, a circle of links.
Result<OutputTarget> output_target(const std::filesystem::path& path);

}  // namespace cambrian
