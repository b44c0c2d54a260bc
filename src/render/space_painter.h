#pragma once

// Draws frames of space: what is around, the floor with the shadow of all solids, the solids lit
// and outlined, and marks. It draws into a picture of its own, which it copies with smooth edges.

#include "render/box_mesh.h"
#include "render/opengl/painted_texture.h"
#include "render/opengl/shader.h"
#include "render/pixel_rect.h"
#include "render/space_frame.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace cambrian {

// Further solids neither cast nor receive shadows.
inline constexpr std::size_t kMostShading = 256;

class SpacePainter {
public:
    // Needs a current OpenGL 3.3 context throughout its lifetime.
    static Result<SpacePainter> create();
    ~SpacePainter();
    SpacePainter(SpacePainter&& other) noexcept;
    SpacePainter& operator=(SpacePainter&&) = delete;

    // Fills the target, which must have the size of the camera's picture. Scissoring remains
    // enabled for it.
    void draw(const SpaceFrame& frame, const PixelRect& target);

private:
    struct Instance;
    struct MarkInstance;
    struct Footprint;
    struct Seen;
    class Objects;

    explicit SpacePainter(std::vector<Shader> shaders);
    bool make_room(int width, int height);
    void list_boxes(const SpaceFrame& frame);
    std::vector<Instance> instances_of(const SpaceFrame& frame, bool opaque, bool inked) const;
    Footprint footprint_of(const SpaceFrame& frame) const;
    void draw_shadow(const SpaceFrame& frame, const Seen& seen);
    void draw_around(const SpaceFrame& frame, const Seen& seen);
    void draw_floor(const SpaceFrame& frame, const Seen& seen);
    void draw_solids(const SpaceFrame& frame, const Seen& seen);
    void draw_marks(const SpaceFrame& frame, const Seen& seen);
    void copy_out(const SpaceFrame& frame, const Seen& seen, const PixelRect& target);

    std::vector<Shader> shaders_;
    std::unique_ptr<Objects> objects_;
    std::optional<PaintedTexture> picture_;
    std::optional<PaintedTexture> shadow_;
    std::vector<std::size_t> shading_;  // the solids that cast shadows, in the list of boxes
    std::vector<float> boxes_;
};

}  // namespace cambrian
