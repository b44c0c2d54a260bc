#pragma once

// Numbers as people type them.

#include "core/result.h"

#include <string_view>

namespace cambrian {

// Reads a number with a decimal point or comma, which its unit may follow. Everything else is
// refused, in words for the user: "“0x10” is not a number."
Result<double> typed_number(std::string_view text, std::string_view unit = {});

}  // namespace cambrian
