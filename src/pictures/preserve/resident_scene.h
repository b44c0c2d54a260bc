#pragma once

// Draws one creature of a preserve: its body as its scale allows, its birth and its bites.

#include "pictures/canvas/palette.h"
#include "pictures/scene/character.h"
#include "preserve/engine/preserve_picture.h"
#include "render/camera.h"
#include "render/scene_frame.h"
#include "simulator/settings/trial_settings.h"

#include <cstdint>

namespace cambrian {

// What all creatures of a picture have in common.
struct ShownWorld {
    LookMode mode = LookMode::kLife;
    const WorldArea& area;
    std::uint64_t tick = 0;

    double time() const { return static_cast<double>(tick) * kBrainTick; }  // s
    double seconds_since(std::uint64_t when) const {
        return when > tick ? 1e9 : static_cast<double>(tick - when) * kBrainTick;
    }
};

void add_resident(SceneFrame& frame, const Palette& palette, const Camera& camera,
                  const ResidentPicture& resident, const ShownWorld& world);

// Returns the hue of a lineage in turns; numbers that follow each other have hues far apart.
double lineage_hue(std::uint64_t lineage);

// Returns a circle's radius around a creature that contains its parts, in m.
double reach_of(const ResidentPicture& resident);

// Returns a part or a drawn wall as a shape without colours, slightly rounded.
Shape shape_of(const Rectangle& part);

}  // namespace cambrian
