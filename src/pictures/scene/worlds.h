#pragma once

// The world that an environment is drawn as: the colours of its backdrop, and the light on skins.

#include "pictures/canvas/palette.h"
#include "render/scene_frame.h"
#include "world/environment.h"

namespace cambrian {

enum class WorldKind : unsigned char {
    kMeadow,
    kIce,
    kMoon,
    kWater,
    kSeabed,
    kAir,
    kNight,
    kNightSea,
    kNightSky,
};

// Noon for pictures; the window is pale by day in the light theme, and at dusk in the dark one.
enum class Daytime : unsigned char { kNoon, kPale, kDusk };

constexpr Daytime daytime_of(ThemeKind theme) {
    return theme == ThemeKind::kLight ? Daytime::kPale : Daytime::kDusk;
}

struct DrawnWorld {
    WorldKind kind = WorldKind::kMeadow;
    BackdropRecipe recipe;
    SkinLight light;
    Color grass = {0.0F, 0.0F, 0.0F, 0.0F};   // of blades; transparent where none grow
    Color specks = {0.0F, 0.0F, 0.0F, 0.0F};  // of snow or plankton; the same
    Color words = {};                         // of marks and labels on the ground
};

// Returns the kind of world, by the first rule that fits: a lamp makes night, drag as great as the
// swimmers' makes water, no ground air, little gravity the Moon, little friction ice.
WorldKind world_kind_of(const Environment& environment);
// The world stays where it is until the program ends.
const DrawnWorld& drawn_world(WorldKind kind, Daytime daytime);

// Returns the colours of words that are read on its sky.
const Palette& palette_over(const DrawnWorld& world);

// Gives the frame the backdrop and the light of a world.
void use_world(SceneFrame& frame, const DrawnWorld& world);

}  // namespace cambrian
