#include "persist/text/quoted_text.h"

#include "persist/text/digest_text.h"

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

// Returns the length of the UTF-8 character at the start, or 0 if there is none.
std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return 0;
    }
    const bool overlong = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xf0 && byte(1) < 0x90);
    const bool surrogate = lead == 0xed && byte(1) >= 0xa0;
    const bool beyond = lead == 0xf4 && byte(1) >= 0x90;
    return overlong || surrogate || beyond ? 0 : length;
}

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
