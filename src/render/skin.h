#pragma once

// A body of several boxes under one skin: outlines melt into each other, and inside, a box in front
// covers those behind it with a soft edge. World units are metres, y up.

#include "math/types.h"
#include "render/color.h"

#include <array>
#include <cstddef>

namespace cambrian {

// Further boxes of a skin are not drawn.
inline constexpr std::size_t kMostSkinBoxes = 64;

struct SkinBox {
    Vec2 center = Vec2::Zero();        // m
    Vec2 half_extents = Vec2::Zero();  // m
    double angle = 0.0;                // rad, counter-clockwise
    // Radii of the corners at (+x, +y), (-x, +y), (+x, -y) and (-x, -y), as shares of the smaller
    // half extent.
    std::array<float, 4> roundness = {0.6F, 0.6F, 0.6F, 0.6F};
    Color fill = {};     // without alpha
    float phase = 0.0F;  // waves by which its pattern is shifted
};

enum class SkinPattern : unsigned char { kPlain, kBands, kSpots, kLengthwise, kSaddle, kChevrons };
inline constexpr int kSkinPatterns = 6;

struct Skin {
    std::size_t shapes_below = 0;  // number of the frame's shapes that are behind it
    std::size_t first_box = 0;     // in the frame's list; the first box is in front
    std::size_t boxes = 0;
    double blend = 0.0;          // m; distance over which boxes melt
    double outline_width = 0.0;  // m, inside the edge
    double wave = 1.0;           // m; length of a wave of the pattern
    SkinPattern pattern = SkinPattern::kPlain;
    float crease = 1.0F;  // strength of the shade beside boxes in front, 0 to 1
    float flash = 0.0F;   // share of red over the skin, most along its outline; up to 0.5
    float alpha = 1.0F;
};

// The light in which all skins of a frame are seen. Colours are intensities and may exceed 1.
struct SkinLight {
    Vec3 sun = {0.42, 0.66, 0.62};             // direction towards it; z is towards the viewer
    Color key = {0.82F, 0.78F, 0.70F, 1.0F};   // of the sun
    Color fill = {0.56F, 0.57F, 0.61F, 1.0F};  // of the sky
    Color rim = {0.42F, 0.38F, 0.32F, 1.0F};   // along edges that face up
    Color ink = {0.20F, 0.17F, 0.20F, 1.0F};   // factor of the fill that gives the outline
    Vec2 lamp = Vec2::Zero();                  // m
    double lamp_reach = 1.0;                   // m; where half of its light is left
    float lamp_power = 0.0F;                   // 0 without a lamp
};

}  // namespace cambrian
