#pragma once

#include <string>
#include <string_view>

namespace cambrian {

// A text in quotes with the escapes TOML and JSON share. Bytes that are not UTF-8 become '?'.
std::string quoted_text(std::string_view text);

}  // namespace cambrian
