#pragma once

// The creatures of a preserve that are outstanding in something.

#include "preserve/engine/preserve_picture.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cambrian {

// The creature for which a number is largest.
struct Notable {
    const char* label;
    std::uint64_t creature = 0;
    double number = 0.0;  // above 0
    const char* unit;     // "s" for a time
};
std::vector<Notable> notables_in(const PreservePicture& picture);

// Returns how long a creature has lived, or lived, in s.
double age_of(const Life& life, std::uint64_t tick);

}  // namespace cambrian
