#pragma once

// Draws frames of space: what is around, the floor with the shadow of all solids, the solids lit
// and outlined, and marks. It draws into a picture of its own, which it copies with smooth edges.

#include "render/opengl/painted_texture.h"
#include "render/opengl/shader.h"
#include "render/pixel_rect.h"
#include "render/solid_instances.h"
#include "render/space_buffers.h"
#include "render/space_frame.h"

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace cambrian {

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
    struct Footprint;
    struct Seen;
    struct Place;

    explicit SpacePainter(std::vector<Shader> shaders);
    const Shader& floor_shader(std::size_t features);
    const Shader& solid_shader(std::size_t pattern);
    bool make_room(int width, int height);
    Footprint footprint_of(const SpaceFrame& frame) const;
    void draw_shadow(const SpaceFrame& frame, const Seen& seen);
    void draw_around(const SpaceFrame& frame, const Seen& seen, const Place& place);
    void draw_floor(const SpaceFrame& frame, const Seen& seen);
    void draw_scenery(const SpaceFrame& frame, const Seen& seen, const Place& place);
    void prepare(const Shader& shader, const SpaceFrame& frame, const Seen& seen,
                 double grow) const;
    void draw_runs(std::span<const SolidInstance> instances, const SpaceFrame& frame,
                   const Seen& seen);
    void draw_opaque(const SpaceFrame& frame, const Seen& seen);
    void draw_busy(const SpaceFrame& frame, const Seen& seen, const Place& place);
    void draw_marks(const SpaceFrame& frame, const Seen& seen);
    void copy_out(const SpaceFrame& frame, const Seen& seen, const Place& place);

    std::vector<Shader> shaders_;
    // For each set of features of a floor, and for each pattern.
    std::array<std::optional<Shader>, 8> floors_;
    std::array<std::optional<Shader>, kSkinPatterns> solids_;
    std::unique_ptr<SpaceBuffers> objects_;
    std::optional<PaintedTexture> picture_;
    std::optional<PaintedTexture> shadow_;
    ShadingBoxes boxes_;
};

}  // namespace cambrian
