#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace cambrian {

// A shape in the vertex shader's format, drawn as one instance of a quad. Lengths are in metres,
// positions relative to the camera's centre.
struct ShapeInstance {
    float center_x = 0.0F;
    float center_y = 0.0F;
    float half_x = 0.0F;
    float half_y = 0.0F;
    float cosine = 1.0F;
    float sine = 0.0F;
    float radius = 0.0F;
    float outline_width = 0.0F;
    float blur = 0.0F;
    std::uint32_t fill = 0;
    std::uint32_t outline = 0;
};

// Shape instances in the graphics card's memory, replaced every frame. Needs a current OpenGL
// context.
class VertexBuffer {
public:
    VertexBuffer();
    ~VertexBuffer();
    VertexBuffer(const VertexBuffer&) = delete;
    VertexBuffer& operator=(const VertexBuffer&) = delete;

    void fill(std::span<const ShapeInstance> instances);
    void draw() const;

private:
    unsigned array_ = 0;
    unsigned buffer_ = 0;
    std::size_t count_ = 0;
};

}  // namespace cambrian
