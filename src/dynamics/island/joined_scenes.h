#pragma once

// Scenes of articulated bodies that are advanced as one (dynamics/README.md 21).

#include "world/joined_scenes.h"

#include <memory>
#include <span>

namespace cambrian {

std::unique_ptr<JoinedScenes> join_body_scenes(std::span<PhysicsScene* const> scenes);

}  // namespace cambrian
