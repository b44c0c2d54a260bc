#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// Returns the code points of UTF-8 text; an invalid byte becomes a question mark.
inline std::vector<int> code_points(std::string_view text) {
    std::vector<int> points;
    for (std::size_t i = 0; i < text.size();) {
        const auto lead = static_cast<unsigned char>(text[i]);
        const std::size_t length = lead < 0x80 ? 1 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
        const bool broken = (lead >= 0x80 && lead < 0xC0) || i + length > text.size();
        if (broken) {
            points.push_back('?');
            ++i;
            continue;
        }
        int point = length == 1 ? lead : lead & (0x7F >> length);
        for (std::size_t k = 1; k < length; ++k)
            point = point << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3F);
        points.push_back(point);
        i += length;
    }
    return points;
}

// Returns the text with a space for each line break, tab and other control character, as a name is
// shown.
inline std::string on_one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(),
        [](char letter) { return static_cast<unsigned char>(letter) < 0x20 || letter == 0x7F; },
        ' ');
    return text;
}

}  // namespace cambrian
