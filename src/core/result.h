#pragma once

// Failures that a user can cause, as values: Result<T> has a T or an Error, Status has an Error or
// nothing. Member names are those of std::expected.

#include "core/assert.h"

#include <string>
#include <utility>
#include <variant>

namespace cambrian {

// One sentence that says what was tried, where (file, line, key) and what was expected, so that a
// user can correct it.
struct Error {
    std::string message;
};

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

    bool has_value() const { return state_.index() == 0; }
    explicit operator bool() const { return has_value(); }

    const T& value() const& {
        CAMBRIAN_ASSERT(has_value(), "value() of a failed Result");
        return *std::get_if<0>(&state_);
    }
    T& value() & {
        CAMBRIAN_ASSERT(has_value(), "value() of a failed Result");
        return *std::get_if<0>(&state_);
    }
    T&& value() && { return std::move(value()); }
    const T& operator*() const& { return value(); }
    T& operator*() & { return value(); }
    T&& operator*() && { return std::move(value()); }
    const T* operator->() const { return &value(); }
    T* operator->() { return &value(); }

    const Error& error() const {
        CAMBRIAN_ASSERT(!has_value(), "error() of a successful Result");
        return *std::get_if<1>(&state_);
    }

private:
    std::variant<T, Error> state_;
};

class [[nodiscard]] Status {
public:
    Status() = default;
    Status(Error error) : error_(std::move(error)), failed_(true) {}

    bool has_value() const { return !failed_; }
    explicit operator bool() const { return !failed_; }
    const Error& error() const {
        CAMBRIAN_ASSERT(failed_, "error() of a successful Status");
        return error_;
    }

private:
    Error error_;
    bool failed_ = false;
};

}  // namespace cambrian
