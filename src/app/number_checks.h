#pragma once

// What numbers an option takes. Messages show a number as it was typed.

#include <cstdint>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class Option;
}

namespace cambrian {

// A whole number; one with an exponent that comes to one is one too ("1e+15").
void take_whole(CLI::Option& option, std::int64_t low, std::int64_t high);
void take_real(CLI::Option& option, double low, double high);
// A number that is checked against a range elsewhere.
void take_finite(CLI::Option& option);

}  // namespace cambrian
