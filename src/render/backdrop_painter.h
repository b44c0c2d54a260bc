#pragma once

// Draws backdrops. Sky and hills are painted once for a recipe and a size, as one picture that
// repeats from left to right; a tile of ground once for a recipe, then scaled once for each zoom. A
// frame only copies them: software renderers copy a hundred times faster than they run a shader.
// Painting takes as long as several frames, so a window has it done in steps.

#include "render/backdrop.h"
#include "render/camera.h"
#include "render/opengl/painted_texture.h"
#include "render/opengl/rectangle_buffer.h"
#include "render/opengl/shader.h"
#include "render/pixel_rect.h"

#include <optional>
#include <utility>
#include <vector>

namespace cambrian {

// Whether a backdrop that is not painted yet is painted by the frame that needs it, or a part by
// each frame. Until all are done, frames show its colours without its forms.
enum class Baking : unsigned char { kAtOnce, kInSteps };

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
    // A recipe's pictures for one size of view.
    struct Scenery {
        const BackdropRecipe* recipe = nullptr;
        int width = 0;  // of the views it serves, in pixels
        int height = 0;
        int steps = 0;                       // that are done
        std::optional<PaintedTexture> half;  // the sky, until it is done
        std::optional<PaintedTexture> far;
        std::optional<PaintedTexture> tile;    // of ground
        std::optional<PaintedTexture> ground;  // the tile at `scale`
        double scale = 0.0;                    // pixels per metre
    };

    struct GroundStrip {
        int left, width, surface;  // pixels
    };

    enum : std::size_t { kSky, kFinish, kRidge, kSoil, kScale, kSlope };  // places of the shaders

    explicit BackdropPainter(std::vector<Shader> shaders);
    Scenery& scenery_for(const BackdropRecipe& recipe, const PixelRect& target);
    // Paints the next part, or all.
    void bake(Scenery& scenery, Baking baking);
    void paint_step(Scenery& scenery);
    // The parts count from the lower edge up, chains from far to near.
    void paint_sky(Scenery& scenery, int part);
    void finish_sky(Scenery& scenery, int part);
    void paint_ridge(const Scenery& scenery, std::size_t chain);
    void paint_tile(Scenery& scenery, int part);
    void scale_ground(Scenery& scenery, double pixels_per_metre);
    // `surface` is the height of the horizon in the target, in pixels.
    void copy_far(const Scenery& scenery, const Camera& camera, const PixelRect& target,
                  int surface) const;
    // Draws the ground in a strip of the target, from column `left` on, with its surface at this
    // height.
    void copy_ground(const Scenery& scenery, const Camera& camera, const PixelRect& target,
                     const GroundStrip& strip) const;
    void draw_shaped_ground(const Scenery& scenery, const GroundShape& shape, const Camera& camera,
                            const PixelRect& target);
    // Runs the shader in use over a rectangle of the bound texture.
    void cover(const PixelRect& part);

    std::vector<Shader> shaders_;
    RectangleBuffer rectangle_;
    std::vector<Scenery> sceneries_;  // the last used at the end
    bool unfinished_ = false;
};

}  // namespace cambrian
