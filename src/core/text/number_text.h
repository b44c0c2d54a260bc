#pragma once

#include <string>

namespace cambrian {

// Returns the shortest decimal that reads back to the same bits. It always has a point or an
// exponent, so that every format reads it as a real number: "1.0", "0.1", "-0.0", "1e-05". Numbers
// that are not finite become "inf" and "nan".
std::string real_text(double number);

// Returns the same for people: integers are written in full and without a point.
std::string short_text(double number);

}  // namespace cambrian
