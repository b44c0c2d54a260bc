#pragma once

// Errors and warnings of one file. Each has its code, its place, and the found and the allowed
// values (persist/README.md 2).

#include "core/result.h"
#include "core/text/shown_text.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

class ErrorList {
public:
    static constexpr std::size_t kLimit = 20;  // further errors are left out

    // `place` is a JSON pointer, or "line 3, [table] key"; empty if the message contains the place.
    void error(std::string_view code, std::string_view place, std::string_view message);
    void warn(std::string_view code, std::string_view place, std::string_view message);

    bool empty() const { return errors_.empty(); }
    bool full() const { return errors_.size() >= kLimit; }
    const std::vector<std::string>& warnings() const { return warnings_; }
    // Returns one message: the source's name and the first error, then one line per further error.
    Error as_error(std::string_view source) const;

private:
    std::vector<std::string> errors_;
    std::vector<std::string> warnings_;
};

}  // namespace cambrian
