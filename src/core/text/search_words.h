#pragma once

// Text as it is searched for words that a person typed.

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// Puts the letters of ASCII in lower case; other bytes stay.
inline std::string small_letters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

// Returns the words of a text, in small letters.
inline std::vector<std::string> search_words(std::string_view text) {
    std::istringstream stream{small_letters(std::string(text))};
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

}  // namespace cambrian
