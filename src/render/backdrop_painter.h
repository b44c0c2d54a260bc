#pragma once

// Draws backdrops. Sky and hills are painted once for a recipe and a size, as one picture that
// repeats from left to right; the ground once for a recipe, then scaled once for each zoom. A frame
// only copies them: software renderers copy a hundred times faster than they run a shader.

#include "render/backdrop.h"
#include "render/camera.h"
#include "render/opengl/painted_texture.h"
#include "render/opengl/rectangle_buffer.h"
#include "render/opengl/shader.h"
#include "render/pixel_rect.h"

#include <optional>
#include <vector>

namespace cambrian {

class BackdropPainter {
public:
    // Needs a current OpenGL 3.3 context throughout its lifetime.
    static Result<BackdropPainter> create();

    // Fills the target. Where a driver has no textures of that size, it is filled with the sky's
    // middle colour. Scissoring remains enabled for the target.
    void draw(const BackdropRecipe& recipe, const Camera& camera, const PixelRect& target);

private:
    // A recipe's pictures for one size of view.
    struct Scenery {
        const BackdropRecipe* recipe = nullptr;
        int width = 0;  // of the views it serves, in pixels
        int height = 0;
        std::optional<PaintedTexture> far;
        std::optional<PaintedTexture> tile;    // of ground
        std::optional<PaintedTexture> ground;  // tiles side by side, at `scale`
        double scale = 0.0;                    // pixels per metre
    };

    enum : std::size_t { kSky, kFinish, kRidge, kSoil, kScale };  // places of the shaders

    explicit BackdropPainter(std::vector<Shader> shaders);
    Scenery& scenery_for(const BackdropRecipe& recipe, const PixelRect& target);
    void paint_far(Scenery& scenery);
    void paint_ridges(const Scenery& scenery);
    void paint_tile(Scenery& scenery);
    void scale_ground(Scenery& scenery, double pixels_per_metre);
    // `surface` is the height of y = 0 in the target, in pixels.
    void copy_far(const Scenery& scenery, const Camera& camera, const PixelRect& target,
                  int surface) const;
    void copy_ground(const Scenery& scenery, const Camera& camera, const PixelRect& target,
                     int surface) const;
    // Runs the shader in use over a rectangle of the bound texture.
    void cover(const PixelRect& part);

    std::vector<Shader> shaders_;
    RectangleBuffer rectangle_;
    std::vector<Scenery> sceneries_;  // the last used at the end
};

}  // namespace cambrian
