#pragma once

// Numbers and units as text for people.

#include <string>

namespace cambrian {

// Converts "m/s^2" to "m/s²", "deg" to "°", "x" to "×".
std::string pretty_unit(const std::string& unit);
// Returns about three significant digits without further trailing zeros: "9.81", "0.05", "1 250".
std::string pretty_number(double value);
std::string with_unit(double value, const std::string& unit);
// Like with_unit(), for measured values: those below 0.0005 become 0.
std::string measured(double value, const std::string& unit);
// Converts seconds to "0:04", "12:30", "2 h 05".
std::string pretty_time(double seconds);
// Returns the text with its first letter in upper case.
std::string capitalized(std::string text);
// The reverse, as a label is written within a sentence.
std::string uncapitalized(std::string text);

}  // namespace cambrian
