#pragma once

// Draws what a creature contends with: the cube and the opponent.

#include "creature/phenotype.h"
#include "pictures/canvas/palette.h"
#include "render/camera.h"
#include "render/scene_frame.h"

#include <span>

namespace cambrian {

struct BoutLook {
    Pose cube;
    const Phenotype* opponent = nullptr;  // null without one
    std::span<const Pose> poses = {};     // of its parts
    std::span<const double> stretches = {};
    double hue = 0.0;  // hue of its lineage, in turns
};

void add_bout(SceneFrame& frame, const Palette& palette, const Camera& camera,
              const BoutLook& look);

}  // namespace cambrian
