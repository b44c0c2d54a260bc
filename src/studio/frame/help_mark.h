#pragma once

#include "studio/frame/requests.h"

#include <string>

namespace cambrian {

// Draws a small "?" that opens a help page.
void help_mark(const char* page, Requests& out);
inline constexpr float kHelpMarkHeight = 22.0F;  // in units of 1/96 inch
// Width of the "?" at the right of a panel's heading, in units of 1/96 inch.
inline constexpr float kHelpMarkRoom = 30.0F;
// Draws a panel's name with the "?" of its help page at the right. The name has the accent colour
// while the panel has the keyboard. Other controls may follow on the line.
void place_title(const std::string& title, const char* page, Requests& out);

}  // namespace cambrian
