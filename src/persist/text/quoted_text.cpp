#include "persist/text/quoted_text.h"

#include "core/text/shown_text.h"
#include "persist/text/digest_text.h"

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

// Whether JSON leaves the letter as it is.
bool is_plain(char letter) {
    const auto code = static_cast<unsigned char>(letter);
    return code >= 0x20 && code < 0x7f && letter != '"' && letter != '\\';
}

void append_escaped(std::string& result, char letter) {
    if (letter == '"' || letter == '\\') {
        result += '\\';
        result += letter;
    } else {
        result += "\\u00" + hex_pairs(std::array{static_cast<std::uint8_t>(letter)});
    }
}

// Appends a character of two or three bytes that cannot be shown.
void append_hidden(std::string& result, std::string_view character) {
    unsigned letter =
        static_cast<unsigned char>(character[0]) & (character.size() == 2 ? 31U : 15U);
    for (const char byte : character.substr(1))
        letter = letter << 6 | (static_cast<unsigned char>(byte) & 63U);
    result += "\\u" + hex_pairs(std::array{static_cast<std::uint8_t>(letter >> 8),
                                           static_cast<std::uint8_t>(letter)});
}

}  // namespace

void append_quoted(std::string& result, std::string_view text) {
    result += '"';
    while (!text.empty()) {
        const auto plain = static_cast<std::size_t>(
            std::find_if_not(text.begin(), text.end(), is_plain) - text.begin());
        result += text.substr(0, plain);
        text.remove_prefix(plain);
        if (text.empty()) break;
        const std::size_t length = utf8_length(text);
        if (length == 1) {
            append_escaped(result, text.front());
        } else if ((length == 2 || length == 3) && !is_showable(text.substr(0, length))) {
            append_hidden(result, text.substr(0, length));
        } else {
            result += length == 0 ? "?" : text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    result += '"';
}

std::string quoted_text(std::string_view text) {
    std::string result;
    append_quoted(result, text);
    return result;
}

}  // namespace cambrian
