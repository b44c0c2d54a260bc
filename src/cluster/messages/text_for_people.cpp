#include "cluster/messages/text_for_people.h"

#include "core/text/shown_text.h"

namespace cambrian {

std::string text_for_people(std::string_view text, std::size_t longest) {
    const auto continues = [&](std::size_t i) {
        return (static_cast<unsigned char>(text[i]) & 0xc0) == 0x80;  // a character of UTF-8
    };
    std::size_t end = text.size() < longest ? text.size() : longest;
    while (end > 0 && end < text.size() && continues(end))
        --end;
    return shown_whole(text.substr(0, end));
}

}  // namespace cambrian
