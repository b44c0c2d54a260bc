#include "core/text/shown_text.h"

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

struct Letters {
    char32_t first, last;
};
// Controls, and format characters that reorder, hide or separate what is around them.
constexpr std::array kNotShown = {
    Letters{0x00, 0x1f},       Letters{0x7f, 0x9f},       Letters{0x61c, 0x61c},
    Letters{0x200e, 0x200f},   Letters{0x2028, 0x202e},   Letters{0x2060, 0x206f},
    Letters{0xfeff, 0xfeff},   Letters{0xfff9, 0xfffb},   Letters{0xfffe, 0xffff},
    Letters{0x1d173, 0x1d17a}, Letters{0xe0000, 0xe0fff},
};

char32_t letter_of(std::string_view character) {
    const auto lead = static_cast<unsigned char>(character.front());
    if (character.size() == 1) return lead;
    char32_t letter = lead & (0x7fU >> character.size());
    for (const char byte : character.substr(1))
        letter = letter << 6 | (static_cast<unsigned char>(byte) & 0x3fU);
    return letter;
}

// Returns the text with question marks. Letters in `kept` remain as they are.
std::string cleaned(std::string_view text, std::string_view kept) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        const bool as_it_is = (length > 0 && is_showable(character)) ||
                              (length == 1 && kept.find(text.front()) != std::string_view::npos);
        result += as_it_is ? character : "?";
        text.remove_prefix(character.size());
    }
    return result;
}

bool begins_like_formula(std::string_view cell) {
    return !cell.empty() && std::string_view("=+-@").find(cell.front()) != std::string_view::npos;
}

bool continues(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0) == 0x80;
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char lead = byte(0);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
    if (lead < 0xc2 || lead > 0xf4 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if (!continues(text[i])) return 0;
    }
    const bool overlong = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xf0 && byte(1) < 0x90);
    const bool surrogate = lead == 0xed && byte(1) >= 0xa0;
    const bool beyond = lead == 0xf4 && byte(1) >= 0x90;
    return overlong || surrogate || beyond ? 0 : length;
}

bool is_showable(std::string_view character) {
    const char32_t letter = letter_of(character);
    return std::none_of(kNotShown.begin(), kNotShown.end(), [letter](const Letters& each) {
        return letter >= each.first && letter <= each.last;
    });
}

std::string shown(std::string_view text, std::size_t longest) {
    if (text.size() <= longest) return cleaned(text, "");
    std::size_t end = longest;
    while (end > 0 && longest - end < 3 && continues(text[end]))
        --end;
    return cleaned(text.substr(0, end), "") + "...";
}

std::string in_quotes(std::string_view text, std::size_t longest) {
    return '"' + shown(text, longest) + '"';
}

std::string shown_lines(std::string_view text) {
    return cleaned(text, "\n\t");
}

std::string shown_whole(std::string_view text) {
    return cleaned(text, "");
}

std::string csv_cell(std::string_view text) {
    std::string cell = cleaned(text, "");
    if (begins_like_formula(cell)) cell.insert(0, "'");
    if (cell.find_first_of(",;\"'") == std::string::npos) return cell;
    std::string quoted = "\"";
    for (const char letter : cell) {
        if (letter == '"') quoted += '"';
        quoted += letter;
    }
    return quoted + '"';
}

std::string_view take_csv_cell(std::string_view& line) {
    bool quoted = false;
    std::size_t end = 0;
    for (; end < line.size() && (quoted || line[end] != ','); ++end)
        quoted = quoted != (line[end] == '"');
    const std::string_view cell = line.substr(0, end);
    line.remove_prefix(std::min(end + 1, line.size()));
    return cell;
}

std::string text_of_csv_cell(std::string_view cell) {
    if (cell.size() < 2 || cell.front() != '"' || cell.back() != '"') return std::string(cell);
    std::string text;
    cell = cell.substr(1, cell.size() - 2);
    for (std::size_t i = 0; i < cell.size(); ++i) {
        text += cell[i];
        if (cell[i] == '"') ++i;  // it is written twice
    }
    const bool marked = text.starts_with('\'') && begins_like_formula(text.substr(1));
    return marked ? text.substr(1) : text;
}

}  // namespace cambrian
