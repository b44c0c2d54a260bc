#pragma once

// Converts a creature and its world to shapes.

#include "creature/phenotype.h"
#include "pictures/canvas/palette.h"
#include "pictures/motion/touched_faces.h"
#include "pictures/scene/character.h"
#include "pictures/scene/highlight.h"
#include "render/camera.h"
#include "render/scene_frame.h"

#include <span>
#include <vector>

namespace cambrian {

// A creature to draw, with its parts at `poses`. `touched` has the faces of each part to highlight,
// or is empty.
struct CreatureLook {
    const Phenotype& phenotype;
    std::span<const Pose> poses;
    std::span<const FaceSet> touched = {};
    double hue = 0.0;  // hue of its lineage, in turns
    Highlight highlight = {};
    std::span<const double> stretches = {};  // of each part, or empty: at rest
    // The rest matters to add_being() only.
    LookMode mode = LookMode::kLife;
    Character character = {};
    bool bitten = false;
    bool bites = false;  // or eats
};

// Returns the colour of a part: the lineage's hue with a small shift for each gene node, lighter
// towards the tips.
Color part_color(const BodyPart& part, double hue);

// Adds a grid of metres behind everything, with finer lines the closer the camera is.
void add_grid(SceneFrame& frame, const Palette& palette, const Camera& camera,
              const Viewport& viewport);
void add_ground(SceneFrame& frame, const Palette& palette, const Camera& camera,
                const Viewport& viewport);
void add_shadow(SceneFrame& frame, const CreatureLook& look);
// Adds the light of the world, a small sun. If it is outside the view, the sun is smaller and at
// the edge.
void add_light(SceneFrame& frame, const Camera& camera, const Viewport& viewport,
               const Vec2& place);
inline constexpr double kLightPixels = 16.0;  // radius of its rays
// Adds a pale creature behind the displayed one.
void add_ghost(SceneFrame& frame, const Camera& camera, const CreatureLook& look);
// Draws a creature as the boxes that physics moves.
void add_creature(SceneFrame& frame, const Palette& palette, const Camera& camera,
                  const CreatureLook& look);
// Adds lines along the faces that touch something, and marks at the joints.
void add_touched(SceneFrame& frame, const Color& color, const Camera& camera,
                 const CreatureLook& look);
void add_joints(SceneFrame& frame, const Camera& camera, const CreatureLook& look);

inline constexpr double kTickPixels = 70.0;  // least distance of the ground's ticks

// Returns the distance in metres between labelled marks that are at least `least_pixels` apart: 1,
// 2 or 5 times a power of ten.
double mark_spacing(const Camera& camera, double least_pixels);

// Returns the part in front at a point of the world, or -1.
int part_at(const Phenotype& phenotype, std::span<const Pose> poses, const Vec2& point,
            std::span<const double> stretches = {});

}  // namespace cambrian
