#pragma once

// A lock that tells other processes of this program that a file is being written. It also detects
// when the name leads to another file.

#include "core/files/file_descriptor.h"
#include "core/result.h"

#include <filesystem>

namespace cambrian {

class FileLock {
public:
    FileLock() = default;  // no file
    ~FileLock();
    FileLock(FileLock&& other) noexcept = default;
    FileLock& operator=(FileLock&& other) noexcept;

    // Fails if another lock on the file is held, in this or another process, or if it is not a
    // regular file.
    static Result<FileLock> take(const std::filesystem::path& path);
    // Whether the path still leads to the locked file; true for an empty lock.
    bool in_place() const;

    // Checks that no lock is held on the file of that name. May be called on any thread. A file
    // locked by this process is not opened, since closing it would release SQLite's own locks on
    // it.
    static Status check_free(const std::filesystem::path& path);

private:
    FileLock(FileDescriptor file, std::filesystem::path path)
        : file_(std::move(file)), path_(std::move(path)) {}

    FileDescriptor file_;
    std::filesystem::path path_;
};

}  // namespace cambrian
