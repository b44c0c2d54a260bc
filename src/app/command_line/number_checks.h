#pragma once

// Checks of numbers that options take. Messages show the number as it was typed.

#include <cstdint>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class Option;
}

namespace cambrian {

// Accepts integers, also those with an exponent ("1e+15").
void take_whole(CLI::Option& option, std::int64_t low, std::int64_t high);
void take_real(CLI::Option& option, double low, double high);
// Accepts any finite number, for an option that is checked elsewhere.
void take_finite(CLI::Option& option);

}  // namespace cambrian
