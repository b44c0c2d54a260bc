#include "studio/background/people_words.h"

#include <cstddef>
#include <string_view>

namespace cambrian {
namespace {

bool is_digit(char letter) {
    return letter >= '0' && letter <= '9';
}

// Returns whether a word begins with a code such as "E01 " or "W04 ".
bool is_code(std::string_view words) {
    return words.size() >= 4 && (words[0] == 'E' || words[0] == 'W') && is_digit(words[1]) &&
           is_digit(words[2]) && words[3] == ' ';
}

// Returns the length of a pointer to a gene at the beginning of a text, or 0.
std::size_t pointer_length(std::string_view words) {
    if (!words.starts_with("/nodes/") && !words.starts_with("/brain/")) return 0;
    const std::size_t end = words.find_first_of(": \n");
    return end == std::string_view::npos ? words.size() : end;
}

// Converts "/nodes/0/length" to "part 0 length".
std::string place_words(std::string_view pointer) {
    constexpr std::string_view parts = "/nodes/";
    std::string words = pointer.starts_with(parts) ? "part " : "brain ";
    for (const char letter : pointer.substr(parts.size()))
        words += letter == '/' ? ' ' : letter;
    return words;
}

}  // namespace

std::string people_words(const std::string& message) {
    std::string words;
    const std::string_view all = message;
    for (std::size_t i = 0; i < all.size();) {
        const bool starts = i == 0 || all[i - 1] == ' ' || all[i - 1] == '\n';
        const std::size_t pointer = starts ? pointer_length(all.substr(i)) : 0;
        if (starts && is_code(all.substr(i))) {
            i += 4;
        } else if (pointer > 0) {
            words += place_words(all.substr(i, pointer));
            i += pointer;
        } else {
            words += all[i++];
        }
    }
    return words;
}

}  // namespace cambrian
