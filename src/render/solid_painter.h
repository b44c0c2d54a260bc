#pragma once

// Draws solids in space into a finished picture, by rays. Boxes have round edges, and light, shade
// and the haze of the medium show their form.

#include "core/image.h"
#include "math/pose.h"
#include "render/color.h"
#include "render/space_camera.h"

#include <span>

namespace cambrian {

struct Solid {
    Pose pose;
    Vec3 half_extents = Vec3::Zero();  // m
    double radius = 0.0;               // m, of the edges; below the half extents
    Color fill = {};
};

struct SpaceLight {
    Vec3 direction = Vec3(-0.45, 0.8, 0.4);  // towards the light
    Color above = {};                        // of the light from above and from below
    Color below = {};
    Color haze = {};          // of the medium, into which what is far away fades
    double haze_depth = 4.0;  // m behind the target at which the haze has half
};

// Draws the solids in the rectangle that the camera's picture has, with its top left there.
void paint_solids(Image& image, int left, int top, const SpaceCamera& camera,
                  const SpaceLight& light, std::span<const Solid> solids);

}  // namespace cambrian
