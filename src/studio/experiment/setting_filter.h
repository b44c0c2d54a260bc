#pragma once

#include "evolution/fields/setting_field.h"

#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

// Finds settings by words of their name, key, group or help; case does not matter.
class SettingFilter {
public:
    explicit SettingFilter(std::string_view words);

    bool empty() const { return words_.empty(); }
    // Whether every word occurs somewhere.
    bool finds(const SettingField& field, std::string_view group_title) const;

private:
    std::vector<std::string> words_;
};

}  // namespace cambrian
