#pragma once

// The parts of the table of settings that have files of their own.

#include "evolution/fields/setting_field.h"

#include <string>
#include <vector>

namespace cambrian::setting_table {

Status check_field(const SettingField& field, const SettingRef& ref);  // range or choice
// Rejects settings of bodies, breeding and mutation that contradict one another.
Status check_creatures(const Settings& settings, const EvolutionKinds& kinds);
Status check_founders(const Settings& settings);   // the order of the limits of random creatures
Status check_distances(const Settings& settings);  // the order of limits of light and wall

void add_environment(std::vector<SettingField>& fields);
// The shape of the ground. The check fails where it contradicts other settings.
void add_terrain(TableBuilder& world);
bool is_of_terrain(const SettingField& field);
Status check_terrain(const Settings& settings);
// Adds the goal. check_goal fails if its environment or sensors make the goal impossible.
void add_goal(std::vector<SettingField>& fields, const EvolutionKinds& kinds);
Status check_goal(const Settings& settings, const EvolutionKinds& kinds);
void add_rhythmic_share(TableBuilder& table);  // of random creatures
void add_trials(TableBuilder& trial);          // number of trials per creature and their jitter
// The settings that enable kinds of joints, neuron functions, sensors, organs and references. The
// check fails if no movable joint or no control remains.
void add_body_kinds(std::vector<SettingField>& fields, const EvolutionKinds& kinds);
Status check_body_kinds(const Settings& settings, const EvolutionKinds& kinds);
// Give settings in space their units, ranges and dimensions, and refuse what is not built there.
void adapt_to_space(std::vector<SettingField>& fields);
Status check_space(const Settings& settings, const EvolutionKinds& kinds);
void add_selection(std::vector<SettingField>& fields, const EvolutionKinds& kinds);

}  // namespace cambrian::setting_table
