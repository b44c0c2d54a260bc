#pragma once

// Errors and warnings of one file, each with its code, its place, and the found and allowed values
// (persist/README.md 2).

#include "core/result.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kLongestQuote = 48;    // bytes
inline constexpr std::size_t kLongestReason = 400;  // of another library's message

// Text from a file for use in a message: short, without control characters, in quotes.
std::string shown(std::string_view text, std::size_t longest = kLongestQuote);
std::string in_quotes(std::string_view text);

class ErrorList {
public:
    static constexpr std::size_t kLimit = 20;  // more are counted as one

    // place: a JSON pointer, or "line 3, [table] key"; empty if the message says where.
    void error(std::string_view code, std::string_view place, std::string_view message);
    void warn(std::string_view code, std::string_view place, std::string_view message);

    bool empty() const { return errors_.empty(); }
    bool full() const { return errors_.size() >= kLimit; }
    const std::vector<std::string>& warnings() const { return warnings_; }
    // One message: the source's name and the first error, then one line for each further one.
    Error as_error(std::string_view source) const;

private:
    std::vector<std::string> errors_;
    std::vector<std::string> warnings_;
};

}  // namespace cambrian
