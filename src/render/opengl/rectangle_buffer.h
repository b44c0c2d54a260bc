#pragma once

#include <cstddef>
#include <span>

namespace cambrian {

// Rectangles in the graphics card's memory, as two triangles each. Needs a current OpenGL context.
class RectangleBuffer {
public:
    static constexpr std::size_t kFloats = 12;  // of one rectangle: x and y of six corners

    RectangleBuffer();
    ~RectangleBuffer();
    RectangleBuffer(RectangleBuffer&& other) noexcept;
    RectangleBuffer& operator=(RectangleBuffer&&) = delete;

    void fill(std::span<const float> corners);
    void draw(std::size_t first, std::size_t count) const;

private:
    unsigned array_ = 0;
    unsigned buffer_ = 0;
};

}  // namespace cambrian
