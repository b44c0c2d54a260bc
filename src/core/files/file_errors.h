#pragma once

// The errors of files that cannot be written.

#include "core/result.h"

#include <fmt/core.h>

#include <string>
#include <system_error>

namespace cambrian {

// `name` is the path as it was given, or "to standard output".
inline Error cannot_write(const std::string& name, const std::string& reason) {
    return Error{fmt::format("cannot write {}: {}", name, reason)};
}

// Returns the error for an error code of the operating system; success for 0.
inline Status write_outcome(const std::string& name, int code) {
    if (code == 0) return {};
    return cannot_write(name, std::generic_category().message(code));
}

}  // namespace cambrian
