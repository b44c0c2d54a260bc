#pragma once

#include <string_view>

namespace cambrian {

// Must be raised when the same genome and settings would move or score differently:
//
//     1.0
//     1.1  contact problems solved exactly
//     1.2  contact forces in the middle of steps twice as long; jumping by height measured in every
//          tick, walking by its slowest quarter
inline constexpr std::string_view kSimulatorVersion = "1.2";

}  // namespace cambrian
