#pragma once

// The vertices, instances and textures of space on the graphics processor.

#include "render/box_mesh.h"
#include "render/opengl/gl.h"
#include "render/solid_instances.h"

#include <array>
#include <cstddef>
#include <span>

namespace cambrian {

// Needs a current OpenGL 3.3 context throughout its lifetime.
class SpaceBuffers {
public:
    SpaceBuffers();
    ~SpaceBuffers();
    SpaceBuffers(const SpaceBuffers&) = delete;
    SpaceBuffers& operator=(const SpaceBuffers&) = delete;

    // Makes the numbers of boxes the uniform block 0.
    void use_boxes(std::span<const float> boxes) const;
    void fill(std::span<const SolidInstance> instances) const;
    void draw_solids(std::size_t count) const;
    void draw_marks(std::span<const MarkInstance> marks) const;
    // Runs the shader in use with no data; a strip has four corners, a cover three.
    void draw_strip() const { draw_plain(GL_TRIANGLE_STRIP, 4); }
    void draw_cover() const { draw_plain(GL_TRIANGLES, 3); }

    GLuint grain() const { return grain_; }  // see grain_texture.h

private:
    void draw_plain(GLenum form, GLsizei corners) const;

    BoxMesh mesh_;
    GLuint grain_ = 0;
    GLuint empty_ = 0;
    GLuint solids_ = 0;
    GLuint marks_ = 0;
    std::array<GLuint, 5> buffers_ = {};
};

}  // namespace cambrian
