#pragma once

// Says to other programs of ours that a file is being written to, and notices when it is not the
// file of that name any more.

#include "core/file_descriptor.h"
#include "core/result.h"

#include <filesystem>

namespace cambrian {

class FileLock {
public:
    FileLock() = default;  // of nothing
    ~FileLock();
    FileLock(FileLock&& other) noexcept = default;
    FileLock& operator=(FileLock&& other) noexcept;

    // Fails if another lock on the file is held, here or in another process, and for what is no
    // regular file.
    static Result<FileLock> take(const std::filesystem::path& path);
    // Whether the path still leads to the locked file. True of nothing.
    bool in_place() const;

    // Whether no lock is held on the file of that name. Any thread; a file locked by this process
    // is not opened, for closing it would take SQLite's own locks on it away.
    static Status check_free(const std::filesystem::path& path);

private:
    FileLock(FileDescriptor file, std::filesystem::path path)
        : file_(std::move(file)), path_(std::move(path)) {}

    FileDescriptor file_;
    std::filesystem::path path_;
};

}  // namespace cambrian
