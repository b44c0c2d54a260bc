#include "studio/experiment/setting_filter.h"

#include "core/text/search_words.h"
#include "evolution/fields/setting_words.h"

#include <fmt/core.h>

#include <algorithm>

namespace cambrian {

SettingFilter::SettingFilter(std::string_view words) : words_(search_words(words)) {}

bool SettingFilter::finds(const SettingField& field, std::string_view group_title) const {
    const std::string all =
        small_letters(fmt::format("{}\n{}\n{}\n{}\n{}", plain_label(field), field.key,
                                  plain_help(field), field.help, group_title));
    return std::all_of(words_.begin(), words_.end(), [&all](const std::string& word) {
        return all.find(word) != std::string::npos;
    });
}

}  // namespace cambrian
