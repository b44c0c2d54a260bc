#pragma once

// Draws scene frames with OpenGL. Edges are anti-aliased by distance in the fragment shader, so no
// multisampling is needed and the software renderer stays fast.

#include "render/camera.h"
#include "render/scene_frame.h"
#include "render/shader.h"
#include "render/vertex_buffer.h"

#include <memory>
#include <vector>

namespace cambrian {

// A rectangle of the bound framebuffer; x, y is its lower left corner.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 1;
    int height = 1;
};

class Renderer {
public:
    // Needs a current OpenGL 3.3 context from here to its death.
    static Result<std::unique_ptr<Renderer>> create();

    // Clears the rectangle and draws the frame into it. Leaves blending and scissoring on.
    void draw(const SceneFrame& frame, const Camera& camera, const PixelRect& target);

private:
    explicit Renderer(Shader shader);
    void collect(const SceneFrame& frame, const Camera& camera, const Viewport& viewport);

    Shader shader_;
    VertexBuffer buffer_;
    std::vector<ShapeInstance> instances_;
    int scale_uniform_ = -1;
    int pixel_uniform_ = -1;
};

}  // namespace cambrian
