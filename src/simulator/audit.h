#pragma once

// Whether the physics of a trial can be believed (simulator/README.md 4).

#include "simulator/trial_record.h"
#include "world/scene_kind.h"

#include <cstdint>
#include <string_view>

namespace cambrian {

enum class AuditVerdict : std::uint8_t { kClean, kSuspect, kInvalid };

std::string_view verdict_name(AuditVerdict verdict);  // "clean", "suspect", "invalid"

// Suspect if more than 5 % of the energy scale is unexplained, or if contacts, limits and impacts,
// which can only take energy, added more than 10 % of it.
AuditVerdict judge(const SceneAudit& audit);
// The same for a trial; invalid if its motion could not be computed to the end.
AuditVerdict judge(const TrialRecord& record);

// The settings to compute a trial with once more when its result must be certain: the scene's most
// accurate integrator, a fortieth of the tolerance, a quarter of the contact step.
SceneSettings finer_settings(const SceneSettings& settings, const SceneKind& scene);

}  // namespace cambrian
