#pragma once

#include "app/command_line/command_tree.h"

#include <string>
#include <string_view>

namespace cambrian {

// Returns the manual page, section 1, as roff with the man macros.
std::string manual_page(const Command& program, std::string_view version);

}  // namespace cambrian
