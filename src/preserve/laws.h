#pragma once

// The laws of a preserve that may change while it goes on (preserve/README.md 8).

#include "core/result.h"
#include "evolution/fields/setting_field.h"
#include "evolution/kinds/evolution_kinds.h"
#include "evolution/settings/experiment_settings.h"
#include "preserve/chronicle.h"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace cambrian {

// Returns the settings of a preserve that may be changed, all of them real or whole numbers, in
// the order of display.
std::vector<SettingField> changeable_laws(const EvolutionKinds& kinds);
double law_value(const SettingField& law, ExperimentSettings& settings);

// Returns whether an intervention of that name changes a law.
bool is_law(std::string_view what);
// Returns the intervention that sets a law to a value.
Intervention law_change(const SettingField& law, double value);
// Returns the intervention that a text like "preserve.growth-time=60" asks for. Whether there is
// such a law is found out when it is carried out.
Result<Intervention> law_change_of(std::string_view text);

// Returns the settings after such an intervention. Fails if there is no such law, or if it cannot
// have that value.
Result<SettingsPtr> with_law(const SettingsPtr& settings, const Intervention& change,
                             const EvolutionKinds& kinds);

// Returns the settings in force at the snapshot of a tick, after interventions in their order.
// Fails at one that changes a law in a way that is not allowed.
Result<SettingsPtr> laws_at(const SettingsPtr& founding,
                            std::span<const Intervention> interventions, std::uint64_t tick,
                            const EvolutionKinds& kinds);

// Returns the settings of trials of single creatures of a preserve: its laws, with a goal that is
// possible in its environment.
SettingsPtr trial_settings(const SettingsPtr& laws, const EvolutionKinds& kinds);

}  // namespace cambrian
