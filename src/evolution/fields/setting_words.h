#pragma once

// The words in which newcomers know a setting, beside the field's own term.

#include "evolution/fields/setting_field.h"

#include <span>
#include <string>
#include <string_view>

namespace cambrian {

struct SettingWords {
    std::string_view path;  // "environment.friction", or "environment" for the choice of a preset
    std::string_view word;  // "Grip"; empty if the term itself is such a word
    std::string_view hint;  // what it does, in a sentence; empty for the field's own help
};

std::span<const SettingWords> all_setting_words();
// Returns null for a setting that has only its term.
const SettingWords* setting_words(std::string_view path);

// Returns "Grip (friction)", or the label alone, and what the setting does.
std::string plain_label(const SettingField& field);
std::string plain_help(const SettingField& field);

// Returns the words as a help page in Markdown.
std::string words_text(const std::vector<SettingField>& fields);

}  // namespace cambrian
