#pragma once

#include <filesystem>
#include <utility>

namespace cambrian {

// A database file that a command has made. It is removed, unless keep() was called, so that a
// command that could not start leaves nothing behind and can be given again.
class StartedFile {
public:
    StartedFile() = default;  // no file
    explicit StartedFile(std::filesystem::path path) : path_(std::move(path)) {}
    ~StartedFile();
    StartedFile(StartedFile&& other) noexcept : path_(std::exchange(other.path_, {})) {}
    StartedFile& operator=(StartedFile&& other) noexcept {
        std::swap(path_, other.path_);
        return *this;
    }

    void keep() { path_.clear(); }

private:
    std::filesystem::path path_;  // empty for none
};

}  // namespace cambrian
