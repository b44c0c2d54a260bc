#pragma once

// The depth to which a TOML text nests, known before it is parsed. The library makes and deletes
// nested values by functions that call themselves, and keys with dots nest without any bracket.

#include <cstddef>
#include <string_view>

namespace cambrian {

inline constexpr std::size_t kDeepestToml = 32;  // levels of names, lists and tables

// Returns the number of the first line that has a value deeper than kDeepestToml; 0 if there is
// none. For a text that is not TOML, what follows its first error may count or not.
std::size_t line_nested_too_deeply(std::string_view text);

}  // namespace cambrian
