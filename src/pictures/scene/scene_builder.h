#pragma once

// A creature and its world as shapes to draw.

#include "creature/phenotype.h"
#include "pictures/canvas/palette.h"
#include "pictures/motion/touched_faces.h"
#include "pictures/scene/highlight.h"
#include "render/camera.h"
#include "render/scene_frame.h"

#include <span>
#include <vector>

namespace cambrian {

// What to draw of a creature. The plan's parts are at `poses`; `touched` holds the faces to light
// up of each part, or nothing.
struct CreatureLook {
    const Phenotype& phenotype;
    std::span<const Pose> poses;
    std::span<const FaceSet> touched = {};
    double hue = 0.0;  // of its lineage, in turns
    Highlight highlight = {};
};

// The colour of one part: the lineage's hue, moved a little for each gene node, lighter outwards.
Color part_color(const BodyPart& part, double hue);

// Grid of metres, behind everything; finer lines as the camera comes closer.
void add_grid(SceneFrame& frame, const Palette& palette, const Camera& camera,
              const Viewport& viewport);
void add_ground(SceneFrame& frame, const Palette& palette, const Camera& camera,
                const Viewport& viewport);
void add_shadow(SceneFrame& frame, const CreatureLook& look);
// A pale creature behind the one shown.
void add_ghost(SceneFrame& frame, const Camera& camera, const CreatureLook& look);
void add_creature(SceneFrame& frame, const Palette& palette, const Camera& camera,
                  const CreatureLook& look);

inline constexpr double kTickPixels = 70.0;  // least distance of the ground's ticks

// Metres between labelled marks so that they are at least `least_pixels` apart: 1, 2 or 5 times
// a power of ten.
double mark_spacing(const Camera& camera, double least_pixels);

// The front-most part under a point of the world, or -1.
int part_at(const Phenotype& phenotype, std::span<const Pose> poses, const Vec2& point);

}  // namespace cambrian
