#include "render/opengl/vertex_buffer.h"

#include "render/opengl/gl.h"

namespace cambrian {
namespace {

// Converts an offset into the bound buffer to the pointer that OpenGL expects.
const void* buffer_place(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
}

void describe_floats(GLuint location, GLint count, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, sizeof(ShapeInstance),
                          buffer_place(offset));
    glVertexAttribDivisor(location, 1);
}

void describe_color(GLuint location, std::size_t offset) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(ShapeInstance),
                          buffer_place(offset));
    glVertexAttribDivisor(location, 1);
}

}  // namespace

VertexBuffer::VertexBuffer() {
    glGenVertexArrays(1, &array_);
    glGenBuffers(1, &buffer_);
    glBindVertexArray(array_);
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    describe_floats(0, 4, offsetof(ShapeInstance, center_x));
    describe_floats(1, 2, offsetof(ShapeInstance, cosine));
    describe_floats(2, 3, offsetof(ShapeInstance, radius));
    describe_color(3, offsetof(ShapeInstance, fill));
    describe_color(4, offsetof(ShapeInstance, outline));
    glBindVertexArray(0);
}

VertexBuffer::~VertexBuffer() {
    glDeleteBuffers(1, &buffer_);
    glDeleteVertexArrays(1, &array_);
}

void VertexBuffer::fill(std::span<const ShapeInstance> instances) {
    count_ = instances.size();
    glBindBuffer(GL_ARRAY_BUFFER, buffer_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size_bytes()), instances.data(),
                 GL_STREAM_DRAW);
}

void VertexBuffer::draw() const {
    glBindVertexArray(array_);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(count_));
    glBindVertexArray(0);
}

}  // namespace cambrian
