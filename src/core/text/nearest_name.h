#pragma once

// Finds the known name closest to a mistyped one, for "did you mean".

#include <span>
#include <string>
#include <string_view>

namespace cambrian {

// Returns the known name with the smallest edit distance if that is at most a third of the longer
// name's length (and at least 1); otherwise an empty text.
std::string nearest_name(std::string_view name, std::span<const std::string> known);

}  // namespace cambrian
