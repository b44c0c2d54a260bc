#pragma once

// Texts inside documents for browsers.

#include <string>
#include <string_view>

namespace cambrian {

std::string base64(std::string_view bytes);
// Packs bytes more tightly, 13 bits in two of 91 printable characters, none of which has a meaning
// in a script element. The first four bytes are their number, the lowest first.
std::string dense_text(std::string_view bytes);
// Escapes what has a meaning in elements and attributes.
std::string html_text(std::string_view text);
// Escapes JSON inside a script element, which it then cannot end.
std::string script_json(std::string_view json);

}  // namespace cambrian
