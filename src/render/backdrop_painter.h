#pragma once

// Draws backdrops. Sky and hills are painted once for a recipe and a size, as one picture that
// repeats from left to right; a tile of ground once for a recipe, then scaled once for each zoom. A
// frame only copies them: software renderers copy a hundred times faster than they run a shader.
// Painting takes as long as several frames, so a window has it done in steps.

#include "render/backdrop_pictures.h"
#include "render/camera.h"

#include <utility>
#include <vector>

namespace cambrian {

class BackdropPainter {
public:
    // Needs a current OpenGL 3.3 context throughout its lifetime.
    static Result<BackdropPainter> create();

    // Fills the target. Where a driver has no textures of that size, it is filled with the recipe's
    // colours. Scissoring remains enabled for the target.
    void draw(const BackdropRecipe& recipe, const GroundShape& shape, const Camera& camera,
              const PixelRect& target, Baking baking);
    // Returns whether a backdrop drawn since the last call is not painted completely.
    bool take_unfinished() { return std::exchange(unfinished_, false); }

private:
    struct GroundStrip {
        int left, width, surface;  // pixels
    };

    BackdropPainter(BackdropPictures pictures, Shader slope)
        : pictures_(std::move(pictures)), slope_(std::move(slope)) {}
    PaintedBackdrop& scenery_for(const BackdropRecipe& recipe, const PixelRect& target);
    // `surface` is the height of the horizon in the target, in pixels.
    void copy_far(const PaintedBackdrop& scenery, const Camera& camera, const PixelRect& target,
                  int surface) const;
    // Draws the ground in a strip of the target, from column `left` on, with its surface at this
    // height.
    void copy_ground(const PaintedBackdrop& scenery, const Camera& camera, const PixelRect& target,
                     const GroundStrip& strip) const;
    void draw_shaped_ground(const PaintedBackdrop& scenery, const GroundShape& shape,
                            const Camera& camera, const PixelRect& target);

    BackdropPictures pictures_;
    Shader slope_;  // draws ground below a slope
    RectangleBuffer rectangle_;
    std::vector<PaintedBackdrop> sceneries_;  // the last used at the end
    bool unfinished_ = false;
};

}  // namespace cambrian
