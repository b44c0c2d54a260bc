#pragma once

// Pages, *.html: documents for browsers with a creature file inside, in an element of type
// application/json. Any bytes are safe to read.

#include "core/result.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace cambrian {

inline constexpr std::string_view kPageEnding = ".html";
inline constexpr std::string_view kCreatureElement = "cambrian-creature";
inline constexpr std::size_t kMaxPageBytes = 64'000'000;

// Returns whether bytes are the beginning of a page.
bool is_page(std::string_view start);

// Returns the text of the first creature file inside. `source` names the page in messages.
Result<std::string> page_document(std::string_view bytes, std::string_view source);

}  // namespace cambrian
