#pragma once

// Overlays of what creatures give off: sounds as rings, scent as a tint.

#include "render/camera.h"
#include "render/scene_frame.h"
#include "simulator/surroundings/scent_field.h"
#include "world/emissions.h"

#include <span>

namespace cambrian {

// Adds a dot at each sound in the colour of its band, and rings at the distances at which a half, a
// quarter and an eighth of a full sound is heard.
void add_sounds(SceneFrame& frame, const Camera& camera, std::span<const Sound> sounds);

// Adds a tint where there is scent, stronger the more of it a nose reads. Weaker scent than a nose
// can tell from none is left out.
void add_scent(SceneFrame& frame, const Camera& camera, const Viewport& viewport,
               const ScentField& field);

}  // namespace cambrian
