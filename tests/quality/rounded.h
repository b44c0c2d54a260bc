#pragma once

#include <cstdio>
#include <string>

namespace cambrian::quality {

// Formats with three digits, since runs vary widely.
inline std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

}  // namespace cambrian::quality
