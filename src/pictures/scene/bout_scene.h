#pragma once

// Draws what a creature contends with: the cube and the opponent.

#include "creature/phenotype.h"
#include "pictures/canvas/palette.h"
#include "pictures/scene/character.h"
#include "render/camera.h"
#include "render/scene_frame.h"

#include <span>

namespace cambrian {

struct BoutLook {
    Pose cube;
    const Phenotype* opponent = nullptr;  // null without one
    std::span<const Pose> poses = {};     // of its parts
    std::span<const double> stretches = {};
    double hue = 0.0;     // hue of its lineage, in turns
    double beside = 0.0;  // that of the creature it contends with
    LookMode mode = LookMode::kLife;
    double time = 0.0;  // s of the trial
};

// Returns the hue in which an opponent is drawn: its own, or the opposite one if that is too close
// to the hue of the creature it contends with. Hues are in turns.
double apart_from(double hue, double opponent);

// Extends the window of a creature by the cube and the opponent.
WorldWindow with_bout(const WorldWindow& body, const BoutLook& look);

void add_bout(SceneFrame& frame, const Palette& palette, const Camera& camera,
              const BoutLook& look);

}  // namespace cambrian
