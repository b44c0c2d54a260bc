#pragma once

// The groups in which settings are shown.

#include "evolution/fields/setting_field.h"

#include <array>
#include <string>
#include <string_view>

namespace cambrian {

// Returns the table whose group shows a setting: its own, except for senses that a world takes
// away.
std::string shown_table(const SettingField& field);
// Returns the title of a table's group; a table without one has its own name.
std::string group_title(const std::string& table);
// Returns the place of a table in the order shown; tables without one come last.
std::size_t group_rank(std::string_view table);
// Whether the group is open at first.
bool is_open_at_first(std::string_view table);

// The settings of the plain panel, in the order shown. A table stands for the choice among its
// presets.
inline constexpr std::array<std::string_view, 6> kPlainSettings = {
    "goal.behavior",        "environment",     "environment.gravity",
    "environment.friction", "population.size", "mutation.rate"};
bool is_plain(std::string_view path);

}  // namespace cambrian
