#pragma once

// Whole files in, whole files out.

#include "core/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

namespace cambrian {

// The file's bytes. Fails, naming the file, if it is missing, a directory, unreadable or larger
// than max_bytes (which is checked before anything is read).
Result<std::string> read_file(const std::filesystem::path& path, std::size_t max_bytes);

// The file's first bytes, as many as there are up to `most`. Fails as read_file does.
Result<std::string> read_start(const std::filesystem::path& path, std::size_t most);

// Writes beside the target, flushes to the disk, renames: the target is the old file or the new
// one, never half of either. On failure the temporary file is removed. Links are followed; devices
// and pipes are written to as they are.
Status write_file(const std::filesystem::path& path, std::string_view bytes);

// A file that another program writes: beside the target under another name until it is whole. On
// the target's own name only once committed; taken away if that never comes.
class PendingFile {
public:
    // Fails for a target that is a folder, a device or a pipe.
    static Result<PendingFile> beside(const std::filesystem::path& target);
    ~PendingFile();
    PendingFile(PendingFile&& other) noexcept;
    PendingFile& operator=(PendingFile&&) = delete;

    // Where to write; nothing is there yet.
    const std::filesystem::path& path() const { return temporary_; }
    // Flushes to the disk and renames.
    Status commit();

private:
    explicit PendingFile(std::filesystem::path target);

    std::filesystem::path target_;     // links followed
    std::filesystem::path temporary_;  // empty once renamed
};

// Whether write_file could succeed now, found out by trying beside the target; leaves nothing
// behind. The message is the one write_file would give.
Status check_writable(const std::filesystem::path& path);

// A name for a new file in the target's folder, given to nobody else.
std::filesystem::path temporary_beside(const std::filesystem::path& target);

// Flushes a file to the disk and puts it in the target's place. On failure it is removed.
Status move_into_place(const std::filesystem::path& temporary, const std::filesystem::path& target);
// The same where there is nothing yet; fails if there is.
Status move_to_new(const std::filesystem::path& temporary, const std::filesystem::path& target);

}  // namespace cambrian
