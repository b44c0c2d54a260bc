#pragma once

// Draws a preserve: its water, walls and food, and all creatures in the hues of their lineages.
// Where edges meet, it is drawn again beyond them.

#include "pictures/canvas/palette.h"
#include "pictures/preserve/resident_scene.h"
#include "pictures/scene/worlds.h"
#include "preserve/engine/preserve_picture.h"
#include "render/camera.h"
#include "render/scene_frame.h"

#include <cstdint>
#include <optional>
#include <set>

namespace cambrian {

// The creatures that are marked, by number.
struct WorldMarks {
    std::uint64_t picked = 0;  // 0 for none
    std::set<std::uint64_t> pins;
    // Whether a ring around each creature shows its store. It is complete, and green, when the
    // store is enough to bear a child.
    bool energy = false;
    LookMode look = LookMode::kLife;
    std::optional<Daytime> scenery = {};  // none: on the palette's sky, with a grid
};

void add_world(SceneFrame& frame, const Palette& palette, const Camera& camera,
               const Viewport& viewport, const PreservePicture& picture, const WorldMarks& marks);

// Returns the middle of a view of so many metres' height that shows a whole world. A meadow may be
// a narrow strip; the rest of the view is its sky.
Vec2 middle_of_view(const WorldArea& area, double height);
inline constexpr double kGroundShare = 0.2;  // of a view, below the ground of a meadow

// Returns the image of a point of the world that is nearest to another point (m).
Vec2 image_near(const WorldArea& area, const Vec2& point, const Vec2& there);

// Returns the number of the creature at a point of the world, or within `reach` (m) of one's centre
// of mass; 0 if there is none. Where edges meet, images count too.
std::uint64_t resident_at(const PreservePicture& picture, const Vec2& point, double reach);

}  // namespace cambrian
