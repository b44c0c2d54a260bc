#pragma once

// A file that is being written: it is beside its target under a temporary name until commit(), and
// is removed if that is never called. Files left by a killed process are removed when the next one
// is made in the same folder.

#include "core/files/file_descriptor.h"
#include "core/result.h"

#include <filesystem>
#include <string_view>
#include <utility>

namespace cambrian {

class PendingFile {
public:
    // Makes an empty file. Fails if the target is not a regular file, or is locked by a process of
    // this program (core/files/file_lock.h).
    static Result<PendingFile> beside(const std::filesystem::path& target);
    ~PendingFile();
    PendingFile(PendingFile&& other) noexcept;
    PendingFile& operator=(PendingFile&&) = delete;

    // The temporary path, to which other programs may write.
    const std::filesystem::path& path() const { return temporary_; }
    // The path that it replaces, with all links followed.
    const std::filesystem::path& target() const { return target_; }
    // Returns the error code, or 0.
    int write(std::string_view bytes) { return write_all(file_.get(), bytes); }

    enum class Existing : unsigned char { kReplace, kRefuse };
    // Flushes the file to the disk and renames it. It gets the permissions of a file that it
    // replaces. Fails if it is a database with changes that are only in the log beside it.
    Status commit(Existing existing = Existing::kReplace);

private:
    PendingFile(std::filesystem::path target, std::filesystem::path temporary, FileDescriptor file)
        : target_(std::move(target)), temporary_(std::move(temporary)), file_(std::move(file)) {}
    int put_in_place(Existing existing);

    std::filesystem::path target_;     // with all links followed
    std::filesystem::path temporary_;  // empty after the rename
    FileDescriptor file_;              // locked to show that it is being written
};

}  // namespace cambrian
