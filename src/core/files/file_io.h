#pragma once

// Reads and writes complete files.

#include "core/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace cambrian {

// Returns the file's bytes. Fails, naming the file, if it is missing, a directory, unreadable or
// larger than max_bytes. The size is checked before anything is read.
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes);

// Returns the file's first bytes, at most `most`. Fails under the same conditions as read_file().
Result<std::string> read_start(const std::filesystem::path& path, std::size_t most);

// Writes a temporary file beside the target, flushes it to the disk and renames it, so that the
// target is always either the old or the new file. On failure the temporary file is removed. Links
// are followed; streams are written to directly (core/files/output_stream.h).
Status write_file(const std::filesystem::path& path, std::string_view bytes);

// Checks, by creating a temporary file beside the target, whether write_file() would succeed now.
// Leaves no file behind. The message is that of write_file().
Status check_writable(const std::filesystem::path& path);

}  // namespace cambrian
