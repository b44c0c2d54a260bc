#pragma once

#include "core/files/file_io.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace cambrian::bench {

// Writes the results to a file, if one was requested. Returns the exit status.
inline int write_table(const std::filesystem::path& path, const std::string& text) {
    if (path.empty()) return EXIT_SUCCESS;
    const Status written = write_file(path, text);
    if (!written) std::fprintf(stderr, "%s\n", written.error().message.c_str());
    return written ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace cambrian::bench
