#pragma once

#include "evolution/fields/setting_field.h"

#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// Finds settings whose name, key, group or help contains given words, in upper or lower case.
class SettingFilter {
public:
    explicit SettingFilter(std::string_view words);

    bool empty() const { return words_.empty(); }
    // Returns whether every word occurs in one of the field's texts.
    bool finds(const SettingField& field, std::string_view group_title) const;

private:
    std::vector<std::string> words_;
};

}  // namespace cambrian
