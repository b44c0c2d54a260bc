#pragma once

#include "studio/frame/requests.h"

#include <string>

namespace cambrian {

// A small "?" that opens a page of the help.
void help_mark(const char* page, Requests& out);
// Room at the right of a panel's heading that its "?" takes, in units of 1/96 inch.
inline constexpr float kHelpMarkRoom = 30.0F;
// A panel's name at its top, in the accent colour while the panel has the keyboard, and the "?" of
// its page at the right; more may follow on the line.
void place_title(const std::string& title, const char* page, Requests& out);

}  // namespace cambrian
