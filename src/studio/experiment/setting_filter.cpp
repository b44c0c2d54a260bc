#include "studio/experiment/setting_filter.h"

#include "evolution/fields/setting_words.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace cambrian {
namespace {

std::string small_letters(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text;
}

}  // namespace

SettingFilter::SettingFilter(std::string_view words) {
    std::istringstream text{small_letters(std::string(words))};
    for (std::string word; text >> word;)
        words_.push_back(word);
}

bool SettingFilter::finds(const SettingField& field, std::string_view group_title) const {
    const std::string all =
        small_letters(fmt::format("{}\n{}\n{}\n{}\n{}", plain_label(field), field.key,
                                  plain_help(field), field.help, group_title));
    return std::all_of(words_.begin(), words_.end(), [&all](const std::string& word) {
        return all.find(word) != std::string::npos;
    });
}

}  // namespace cambrian
