#pragma once

#include <cstdio>
#include <string>

namespace cambrian::quality {

// Three digits are all that runs which vary so much deserve.
inline std::string rounded(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

}  // namespace cambrian::quality
