#pragma once

// Says to other programs of ours that a file is being written to, and notices when it is not the
// file of that name any more.

#include "core/result.h"

#include <filesystem>

namespace cambrian {

class FileLock {
public:
    FileLock() = default;  // of nothing
    ~FileLock();
    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;

    // Fails if another lock on the file is held, here or in another process.
    static Result<FileLock> take(const std::filesystem::path& path);
    // Whether the path still leads to the locked file. True of nothing.
    bool in_place() const;

    // Whether one could be taken, or there is no such file.
    static Status check_free(const std::filesystem::path& path);

private:
    FileLock(int file, std::filesystem::path path) : file_(file), path_(std::move(path)) {}

    int file_ = -1;
    std::filesystem::path path_;
};

}  // namespace cambrian
