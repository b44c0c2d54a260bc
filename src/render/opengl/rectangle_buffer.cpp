#include "render/opengl/rectangle_buffer.h"

#include "render/opengl/gl.h"

#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kCorners = RectangleBuffer::kFloats / 2;

}  // namespace

RectangleBuffer::RectangleBuffer() {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &buffer_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 2 * sizeof(float), nullptr);
    glBindVertexArray(0);
}

RectangleBuffer::RectangleBuffer(RectangleBuffer&& other) noexcept
    : array_(std::exchange(other.array_, 0)), buffer_(std::exchange(other.buffer_, 0)) {}

RectangleBuffer::~RectangleBuffer() {
    if (buffer_ != 0) glDeleteBuffers(1, &buffer_);
    if (array_ != 0) glDeleteVertexArrays(1, &array_);
}

void RectangleBuffer::fill(std::span<const float> corners) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size_bytes()), corners.data(),
                 GL_STREAM_DRAW);
}

void RectangleBuffer::draw(std::size_t first, std::size_t count) const {
    glBindVertexArray(array_);
    glDrawArrays(GL_TRIANGLES, static_cast<GLint>(first * kCorners),
                 static_cast<GLsizei>(count * kCorners));
    glBindVertexArray(0);
}

}  // namespace cambrian
