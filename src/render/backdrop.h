#pragma once

// The scenery behind a frame, as a recipe: a sky, three chains of hills or clouds before it, and
// the ground below its surface, cut open. Everything in it follows from the recipe and the size of
// the view.

#include "math/types.h"
#include "render/color.h"

#include <array>
#include <vector>

namespace cambrian {

// The surface of the ground in a view.
struct GroundShape {
    std::vector<Vec2>
        surface;         // m, from left to right, beyond both sides of the view; empty: y = 0
    double level = 0.0;  // m; height at which the horizon lies

    bool is_flat() const { return surface.empty(); }
    double at(double x) const;  // m
};

enum class HeavenlyBody : unsigned char { kNone, kSun, kCrescent, kEarth };
enum class RidgeForm : unsigned char { kHills, kDunes, kBergs, kClouds, kSeabed };
enum class SoilForm : unsigned char { kTurf, kRegolith, kIce, kSand };

struct BackdropRecipe {
    std::array<Color, 3> sky;  // at the horizon, half way up, above
    HeavenlyBody body = HeavenlyBody::kNone;
    Color body_color = {};
    Vec2 body_place = Vec2(0.8, 0.74);  // shares of the view's width and height, y up
    double body_radius = 0.06;          // share of the view's height
    float stars = 0.0F;                 // share of the possible ones, 0 to 1
    float clouds = 0.0F;                // opacity, 0 to 1
    float shafts = 0.0F;                // strength of light that falls into water, 0 to 1
    RidgeForm form = RidgeForm::kHills;
    std::array<std::array<Color, 2>, 3> ridges;  // far to near: crest and foot
    bool has_ground = true;
    SoilForm soil = SoilForm::kTurf;
    std::array<Color, 4> ground;  // cover, soil below it, deep soil, stones
};

}  // namespace cambrian
