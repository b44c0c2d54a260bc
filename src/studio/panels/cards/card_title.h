#pragma once

#include "studio/frame/requests.h"

#include <string>

namespace cambrian {

// Draws the first line of a card: its title, at the right a button that closes it and, unless
// `page` is null, the "?" of its help page. `close` identifies the button. Returns true when it was
// pressed.
bool card_title(const std::string& title, const char* close, const char* page, Requests& out);

}  // namespace cambrian
