#pragma once

// Draws scene frames with OpenGL. Edges are anti-aliased by distance in the fragment shader, so no
// multisampling is needed and the software renderer stays fast.

#include "render/backdrop_painter.h"
#include "render/camera.h"
#include "render/opengl/shader.h"
#include "render/opengl/vertex_buffer.h"
#include "render/pixel_rect.h"
#include "render/scene_frame.h"
#include "render/skin_painter.h"
#include "render/space_painter.h"

#include <memory>
#include <span>
#include <vector>

namespace cambrian {

class Renderer {
public:
    // Needs a current OpenGL 3.3 context throughout its lifetime.
    static Result<std::unique_ptr<Renderer>> create();

    // Clears the rectangle and draws the frame into it. Boxes at the start of the frame are rounded
    // to pixels if they are opaque, upright and sharp. Blending and scissoring remain enabled.
    void draw(const SceneFrame& frame, const Camera& camera, const PixelRect& target,
              Baking baking = Baking::kAtOnce);
    // Returns whether a frame that was drawn since the last call lacks scenery, which further
    // frames will add.
    bool take_unfinished() { return backdrop_painter_.take_unfinished(); }

private:
    Renderer(Shader shader, SkinPainter skin_painter, BackdropPainter backdrop_painter,
             SpacePainter space_painter);
    void collect(std::span<const Shape> shapes, const Camera& camera, const Viewport& viewport);
    void draw_shapes(std::span<const Shape> shapes, const Camera& camera, const Viewport& viewport);

    Shader shader_;
    SkinPainter skin_painter_;
    BackdropPainter backdrop_painter_;
    SpacePainter space_painter_;
    VertexBuffer buffer_;
    std::vector<ShapeInstance> instances_;
    int scale_uniform_ = -1;
    int pixel_uniform_ = -1;
};

}  // namespace cambrian
