#pragma once

// The verdict on the physics of a trial (simulator/README.md 4).

#include "simulator/trial_record.h"
#include "world/scene_kind.h"

#include <cstdint>
#include <string_view>

namespace cambrian {

enum class AuditVerdict : std::uint8_t { kClean, kSuspect, kInvalid };

std::string_view verdict_name(AuditVerdict verdict);  // "clean", "suspect", "invalid"

// Returns suspect if more than 5 % of the energy scale is unexplained, if contacts, limits and
// impacts, which can only dissipate, added more than 10 % of it, or if the body gained 0.1 % of its
// parts' angular momentum while nothing touched it.
AuditVerdict judge(const SceneAudit& audit);
// Returns the same for a trial; invalid if its motion could not be computed to the end.
AuditVerdict judge(const TrialRecord& record);

// Returns settings for a more accurate repetition of a trial: the scene's most accurate integrator,
// a fortieth of the tolerance, a quarter of the contact step.
SceneSettings finer_settings(const SceneSettings& settings, const SceneKind& scene);

}  // namespace cambrian
