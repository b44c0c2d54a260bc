#pragma once

// Whether the physics of a trial can be believed (physics.md 9).

#include "world/physics_scene.h"

#include <cstdint>

namespace cambrian {

enum class AuditVerdict : std::uint8_t { kClean, kSuspect };

// Suspect if more than 5 % of the energy scale is unexplained, or if contacts, limits and impacts,
// which can only take energy, added more than 10 % of it.
AuditVerdict judge(const SceneAudit& audit);

}  // namespace cambrian
