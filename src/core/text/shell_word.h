#pragma once

#include <algorithm>
#include <cctype>
#include <cstring>
#include <string>

namespace cambrian {

// Returns the text as one word of a shell's command line, quoted if it must be.
inline std::string shell_word(const std::string& text) {
    const bool plain = !text.empty() && std::all_of(text.begin(), text.end(), [](char letter) {
        const auto code = static_cast<unsigned char>(letter);
        return std::isalnum(code) != 0 || code >= 0x80 ||
               std::strchr("/._-+,=@%", letter) != nullptr;
    });
    if (plain) return text;
    std::string quoted = "'";
    for (const char letter : text)
        quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
    return quoted + "'";
}

}  // namespace cambrian
