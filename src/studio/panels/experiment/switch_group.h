#pragma once

// Switches of one group, with a tick box for all of them.

#include "evolution/fields/setting_field.h"
#include "studio/widgets/widgets.h"

#include <span>
#include <string>
#include <vector>

namespace cambrian {

struct SwitchGroup {
    std::string label;
    std::vector<const SettingField*> switches;
};

// Returns the groups of a table's fields in the order of their first field; fields without a group
// are left out.
std::vector<SwitchGroup> switch_groups(std::span<const SettingField> fields,
                                       const std::string& table);

// Returns whether all, some or none of the switches are on.
Tick tick_of(const SwitchGroup& group, ExperimentSettings& settings);
void set_all(const SwitchGroup& group, bool on, ExperimentSettings& settings);

// Draws the row of a group: tick box, name, and how many are on. Returns true if the tick box was
// pressed; a press of the name opens or closes the group.
bool switch_group_row(const SwitchGroup& group, ExperimentSettings& settings, bool& open);

}  // namespace cambrian
