#pragma once

#include <string>

namespace cambrian {

// The shortest decimal that reads back to the same bits, always with a point or an exponent, so
// that it is a real number in every format: "1.0", "0.1", "-0.0", "1e-05". "inf" and "nan" for
// what is not finite.
std::string real_text(double number);

// The same for people: whole numbers in full and without the point.
std::string short_text(double number);

}  // namespace cambrian
