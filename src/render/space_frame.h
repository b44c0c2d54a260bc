#pragma once

// What to draw of a world in space: solids and marks, the floor below them and what is around. It
// knows no creatures. World units are metres, y up.

#include "math/pose.h"
#include "render/color.h"
#include "render/skin.h"
#include "render/space_camera.h"

#include <array>
#include <optional>
#include <vector>

namespace cambrian {

// A box with round edges; a sphere if all half extents are the radius.
struct Solid {
    Pose pose;
    Vec3 half_extents = Vec3::Zero();  // m
    double radius = 0.0;               // m, of the edges; at most the least half extent
    Color fill = {};                   // solids with an alpha below 1 do not hide others
    SkinPattern pattern = SkinPattern::kPlain;
    double wave = 1.0;    // m; length of a wave of the pattern
    float phase = 0.0F;   // waves by which its pattern is shifted
    bool inked = true;    // has an outline
    bool shadows = true;  // casts one
    bool gleams = false;  // like a wet eye
};

struct SpaceLight {
    Vec3 direction = Vec3(-0.45, 0.8, 0.4);   // towards the light
    Color key = {0.95F, 0.93F, 0.88F, 1.0F};  // of the light itself; may exceed 1
    Color above = {};                         // of the light from above and from below
    Color below = {};
    // Colours of the medium in level directions, straight up and straight down. What is far away
    // fades into them.
    std::array<Color, 3> around = {};
    double haze_from = 4.0;   // m from the camera at which the haze begins
    double haze_depth = 4.0;  // m behind that at which it has half
    double dimness = 1.0;     // share of the light that a shadow takes
};

// A level plane.
struct SpaceFloor {
    double height = 0.0;  // m
    Color color = {};
    Color lines = {0.0F, 0.0F, 0.0F, 0.0F};  // of a grid of metres; transparent for none
    float grain = 0.0F;                      // strength of its uneven colour, 0 to 1
    float ripples = 0.0F;                    // strength of light that waves above it gather, 0 to 1
    double time = 0.0;                       // s; ripples move with it
    float shade = 0.6F;                      // strength of shadows on it, 0 to 1
};

// A soft disc that faces the camera and that solids hide.
struct SpaceMark {
    Vec3 place = Vec3::Zero();  // m
    double radius = 0.0;        // m
    double least = 0.0;         // pixels; smaller ones are drawn as large as this
    Color color = {};
    float softness = 0.3F;  // share of the radius over which the edge fades
};

struct SpaceFrame {
    SpaceCamera camera;
    SpaceLight light;
    std::optional<SpaceFloor> floor;
    std::vector<Solid> solids;
    std::vector<SpaceMark> marks;
    double outline = 1.3;  // pixels
    float ink = 0.28F;     // factor of the fill that gives the outline
    // Pixels that are drawn for one of the picture, each way: 1, with edges smoothed afterwards, or
    // 2, which looks better and takes four times as long.
    int samples = 1;
    bool clear = false;  // draws solids alone, on nothing
};

}  // namespace cambrian
