#pragma once

#include "core/hash.h"
#include "world/physics_scene.h"

namespace cambrian::golden {

// Adds every number of the energy audit to a digest.
void add_audit(Hash64& hash, const SceneAudit& audit);

}  // namespace cambrian::golden
