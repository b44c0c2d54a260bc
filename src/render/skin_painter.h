#pragma once

// Draws skins with OpenGL: the processor divides a skin into tiles (skin_tiles.h), and a program
// for each number of boxes a tile may have paints them, without a loop.

#include "render/opengl/rectangle_buffer.h"
#include "render/opengl/shader.h"
#include "render/pixel_rect.h"
#include "render/scene_frame.h"
#include "render/skin_tiles.h"

#include <array>
#include <vector>

namespace cambrian {

class SkinPainter {
public:
    // Needs a current OpenGL 3.3 context throughout its lifetime.
    static Result<SkinPainter> create();

    // Draws one skin of the frame into the target, over what is there. Needs blending, and a
    // viewport of the target.
    void draw(const SceneFrame& frame, const Skin& skin, const Camera& camera,
              const PixelRect& target);

private:
    struct Program {
        explicit Program(Shader linked);
        Shader shader;
        int origin, size, place, extent, corner, tint, form, look, sun, halfway, key, fill, rim,
            ink, lamp;
    };
    explicit SkinPainter(std::vector<Program> programs) : programs_(std::move(programs)) {}
    void place_boxes(const SceneFrame& frame, const Skin& skin, const Camera& camera,
                     const PixelRect& target);
    void use(const Program& program, const SceneFrame& frame, const Skin& skin,
             const Camera& camera, const PixelRect& target) const;
    void give_boxes(const Program& program, const SceneFrame& frame, const Skin& skin,
                    const SkinTile& tile) const;

    // For 1, 2, ... boxes, then the same for light frames.
    std::vector<Program> programs_;
    RectangleBuffer buffer_;
    std::vector<TileBox> boxes_;  // of the skin that is drawn
    std::vector<SkinTile> tiles_;
    std::vector<float> corners_;
};

}  // namespace cambrian
