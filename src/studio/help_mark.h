#pragma once

#include "studio/requests.h"

#include <string>

namespace cambrian {

// A small "?" that opens a page of the help.
void help_mark(const char* page, Requests& out);
// A panel's name at its top, with the "?" of its page at the right.
void place_title(const std::string& title, const char* page, Requests& out);

}  // namespace cambrian
