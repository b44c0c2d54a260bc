#pragma once

#include "core/files/file_descriptor.h"
#include "core/result.h"

#include <filesystem>
#include <string>
#include <utility>

namespace cambrian {

// Returns the folder for temporary files: $TMPDIR or /tmp, whether it can be used or not.
std::filesystem::path temporary_folder();

// Returns "the temporary folder /tmp: " and a reason, for messages.
std::string of_temporary_folder(const std::string& reason);

// A folder within that folder which only this user can enter. It is removed with its contents at
// the end of the scope; what a killed process left is removed when the next one is made.
class PrivateFolder {
public:
    // Fails, naming the temporary folder, if none can be made.
    static Result<PrivateFolder> make();
    ~PrivateFolder();
    PrivateFolder(PrivateFolder&& other) noexcept
        : path_(std::exchange(other.path_, {})), lock_(std::move(other.lock_)) {}
    PrivateFolder& operator=(PrivateFolder&&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    PrivateFolder(std::filesystem::path path, FileDescriptor lock)
        : path_(std::move(path)), lock_(std::move(lock)) {}

    std::filesystem::path path_;
    FileDescriptor lock_;
};

// Makes such a folder that remains, for a file that somebody will look for.
Result<std::filesystem::path> make_lasting_private_folder();

}  // namespace cambrian
