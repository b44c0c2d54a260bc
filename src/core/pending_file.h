#pragma once

// A file on its way: beside its target under another name until it is whole, on the target's own
// name only once committed, taken away if that never comes. What a killed process left of one is
// taken away when the next one is made in the same folder.

#include "core/file_descriptor.h"
#include "core/result.h"

#include <filesystem>
#include <string_view>
#include <utility>

namespace cambrian {

class PendingFile {
public:
    // Makes an empty one. Fails for a target that is no regular file, or that a program of ours
    // has locked (core/file_lock.h).
    static Result<PendingFile> beside(const std::filesystem::path& target);
    ~PendingFile();
    PendingFile(PendingFile&& other) noexcept;
    PendingFile& operator=(PendingFile&&) = delete;

    // Where another program can write to it.
    const std::filesystem::path& path() const { return temporary_; }
    // What it is going to replace, links followed.
    const std::filesystem::path& target() const { return target_; }
    // The error code, 0 if none.
    int write(std::string_view bytes) { return write_all(file_.get(), bytes); }

    enum class Existing : unsigned char { kReplace, kRefuse };
    // Flushes to the disk and renames. A file that is replaced gives it its permissions.
    Status commit(Existing existing = Existing::kReplace);

private:
    PendingFile(std::filesystem::path target, std::filesystem::path temporary, FileDescriptor file)
        : target_(std::move(target)), temporary_(std::move(temporary)), file_(std::move(file)) {}
    int put_in_place(Existing existing);

    std::filesystem::path target_;     // links followed
    std::filesystem::path temporary_;  // empty once renamed
    FileDescriptor file_;              // locked, so that it is known to be written to
};

}  // namespace cambrian
