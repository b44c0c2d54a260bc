#pragma once

#include <string_view>
#include <utility>

namespace cambrian {

// An open file of the operating system; closes it on scope exit.
class FileDescriptor {
public:
    FileDescriptor() = default;  // of nothing
    explicit FileDescriptor(int value) : value_(value) {}
    ~FileDescriptor() { close(); }
    FileDescriptor(FileDescriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
    FileDescriptor& operator=(FileDescriptor&& other) noexcept {
        std::swap(value_, other.value_);
        return *this;
    }

    int get() const { return value_; }
    bool is_open() const { return value_ >= 0; }
    // The error code of closing, 0 if none.
    int close();

private:
    int value_ = -1;
};

// Writes all of the bytes, waiting for a reader that is slow. The error code, 0 if none.
int write_all(int file, std::string_view bytes);

}  // namespace cambrian
