#pragma once

#include <string_view>
#include <utility>

namespace cambrian {

// An open file of the operating system, which is closed at the end of the scope.
class FileDescriptor {
public:
    FileDescriptor() = default;  // no file
    explicit FileDescriptor(int value) : value_(value) {}
    ~FileDescriptor() { close(); }
    FileDescriptor(FileDescriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }

    int get() const { return value_; }
    bool is_open() const { return value_ >= 0; }
    // Closes the file; returns the error code, or 0.
    int close();

private:
    int value_ = -1;
};

// Writes all of the bytes, and waits for a slow reader. Returns the error code, or 0.
int write_all(int file, std::string_view bytes);

}  // namespace cambrian
