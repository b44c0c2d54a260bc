#pragma once

#include "core/hash.h"
#include "world/physics_scene.h"

namespace cambrian::golden {

// Adds every number of the books to a digest.
void add_books(Hash64& hash, const SceneAudit& audit);

}  // namespace cambrian::golden
