#include "persist/text/error_list.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

std::string line_of(std::string_view code, std::string_view place, std::string_view message) {
    std::string line(code);
    if (!line.empty()) line += ' ';
    line += place;
    if (!place.empty()) line += ": ";
    line += message;
    return line;
}

}  // namespace

void ErrorList::error(std::string_view code, std::string_view place, std::string_view message) {
    if (full()) return;
    errors_.push_back(line_of(code, place, message));
}

void ErrorList::warn(std::string_view code, std::string_view place, std::string_view message) {
    if (warnings_.size() < kLimit) warnings_.push_back(line_of(code, place, message));
}

Error ErrorList::as_error(std::string_view source) const {
    CAMBRIAN_ASSERT(!errors_.empty(), "an error to report");
    std::string message = fmt::format("{}: {}", source, errors_.front());
    for (std::size_t i = 1; i < errors_.size(); ++i)
        message += "\n  " + errors_[i];
    if (full()) message += fmt::format("\n  no more errors are looked for after {}", kLimit);
    return {std::move(message)};
}

}  // namespace cambrian
