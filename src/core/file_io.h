#pragma once

// Whole files in, whole files out.

#include "core/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace cambrian {

// The file's bytes. Fails, naming the file, if it is missing, a directory, unreadable or larger
// than max_bytes (which is checked before anything is read).
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes);

// The file's first bytes, as many as there are up to `most`. Fails as read_file does.
Result<std::string> read_start(const std::filesystem::path& path, std::size_t most);

// Writes beside the target, flushes to the disk, renames: the target is the old file or the new
// one, never half of either. On failure the temporary file is removed. Links are followed; streams
// are written to as they are (core/output_stream.h).
Status write_file(const std::filesystem::path& path, std::string_view bytes);

// Whether write_file could succeed now, found out by trying beside the target; leaves nothing
// behind. The message is the one write_file would give.
Status check_writable(const std::filesystem::path& path);

}  // namespace cambrian
