#pragma once

// Numbers and units as people read them.

#include <string>

namespace cambrian {

// As std::snprintf.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

// "m/s^2" as "m/s²", "deg" as "°", "x" as "×".
std::string pretty_unit(const std::string& unit);
// Three significant digits or so, no trailing zeros beyond them: "9.81", "0.05", "1 250".
std::string pretty_number(double value);
std::string with_unit(double value, const std::string& unit);
// As with_unit, of something measured: what is smaller than half a thousandth is 0.
std::string measured(double value, const std::string& unit);
// "0:04", "12:30", "2 h 05"; from seconds.
std::string pretty_time(double seconds);
// First letter large.
std::string capitalized(std::string text);

}  // namespace cambrian
