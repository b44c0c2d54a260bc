#pragma once

#include <string>
#include <string_view>

namespace cambrian {

// Quotes a text with the escapes that TOML and JSON share. Characters that
// cannot be shown (core/text/shown_text.h) are escaped; bytes that are not UTF-8 become '?'.
std::string quoted_text(std::string_view text);
// Appends the quoted text.
void append_quoted(std::string& result, std::string_view text);

}  // namespace cambrian
