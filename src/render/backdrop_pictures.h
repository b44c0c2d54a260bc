#pragma once

// The pictures that a backdrop is copied from: the sky with its hills, which repeats from left to
// right, and a tile of ground, scaled once for each zoom.

#include "render/backdrop.h"
#include "render/opengl/painted_texture.h"
#include "render/opengl/rectangle_buffer.h"
#include "render/opengl/shader.h"
#include "render/pixel_rect.h"

#include <optional>
#include <vector>

namespace cambrian {

// Whether a backdrop that is not painted yet is painted by the frame that needs it, or a part by
// each frame. Until all are done, frames show its colours without its forms.
enum class Baking : unsigned char { kAtOnce, kInSteps };

// A recipe's pictures for one size of view.
struct PaintedBackdrop {
    static constexpr int kLeastWidth = 1024;  // px, so that hills do not repeat soon

    const BackdropRecipe* recipe = nullptr;
    int width = 0;  // of the views it serves, in pixels
    int height = 0;
    int steps = 0;                       // that are done
    std::optional<PaintedTexture> half;  // the sky, until it is done
    std::optional<PaintedTexture> far;
    std::optional<PaintedTexture> tile;    // of ground
    std::optional<PaintedTexture> ground;  // the tile at `scale`
    double scale = 0.0;                    // pixels per metre

    bool is_finished() const;
    int horizon() const { return height * 26 / 100; }  // in `far`, pixels
};

class BackdropPictures {
public:
    // Needs a current OpenGL 3.3 context throughout its lifetime.
    static Result<BackdropPictures> create();

    // Paints the next part, or all.
    void bake(PaintedBackdrop& pictures, Baking baking);
    void scale_ground(PaintedBackdrop& pictures, double pixels_per_metre);

private:
    enum : std::size_t { kSky, kFinish, kRidge, kSoil, kScale };  // places of the shaders

    explicit BackdropPictures(std::vector<Shader> shaders);
    void paint_step(PaintedBackdrop& pictures);
    // The parts count from the lower edge up, chains from far to near.
    void paint_sky(PaintedBackdrop& pictures, int part);
    void finish_sky(PaintedBackdrop& pictures, int part);
    void paint_ridge(const PaintedBackdrop& pictures, std::size_t chain);
    void paint_tile(PaintedBackdrop& pictures, int part);
    // Runs the shader in use over a rectangle of the bound texture.
    void cover(const PixelRect& part);

    std::vector<Shader> shaders_;
    RectangleBuffer rectangle_;
};

// Returns the program of a shader of backdrops.
Result<Shader> backdrop_shader(const char* source);

}  // namespace cambrian
