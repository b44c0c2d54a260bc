#pragma once

// Draws the edges of a preserve: its walls, or the images of the world beyond edges that meet.

#include "pictures/canvas/palette.h"
#include "preserve/engine/preserve_picture.h"
#include "render/camera.h"
#include "render/scene_frame.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cambrian {

// Paints what is beyond the walls and, unless scenery shows it, below the ground, and the walls.
void add_walls(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const Viewport& viewport, const WorldArea& area, bool scenery);

// Marks where edges meet by thin lines: the left and the lower edge, of which the others are
// images.
void add_seams(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const WorldArea& area);

// Returns how far the images of the world that are drawn are from it, in m. The first one is its
// own.
std::vector<Vec2> image_shifts(const WorldArea& area);

// Returns whether a circle may be in the view.
bool in_view(const Vec2& center, double reach, const WorldWindow& window);

// Adds the shapes from this one on, and the skins over them, again in each image of the world,
// where they are in view.
void repeat_from(std::size_t first, SceneFrame& frame, const WorldWindow& window,
                 std::span<const Vec2> shifts);

}  // namespace cambrian
