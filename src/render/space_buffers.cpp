#include "render/space_buffers.h"

#include "render/grain_texture.h"

namespace cambrian {
namespace {

constexpr int kEdgeSteps = 2;  // of a quarter of a round edge, halved

const void* place_in_buffer(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
}

void describe(GLuint location, GLint count, std::size_t stride, std::size_t offset,
              GLuint divisor) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          place_in_buffer(offset));
    glVertexAttribDivisor(location, divisor);
}

template <class Item>
void fill_buffer(GLuint buffer, std::span<const Item> items, GLenum use) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size_bytes()), items.data(), use);
}

}  // namespace

SpaceBuffers::SpaceBuffers() : mesh_(rounded_box(kEdgeSteps)) {
    glGenVertexArrays(1, &empty_);
    glGenVertexArrays(1, &solids_);
    glGenVertexArrays(1, &marks_);
    glGenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    glBindVertexArray(solids_);
    fill_buffer<BoxVertex>(buffers_[0], mesh_.vertices, GL_STATIC_DRAW);
    describe(0, 3, sizeof(BoxVertex), offsetof(BoxVertex, corner), 0);
    describe(1, 3, sizeof(BoxVertex), offsetof(BoxVertex, normal), 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(mesh_.triangles.size() * sizeof(unsigned)),
                 mesh_.triangles.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[2]);
    for (GLuint i = 0; i < sizeof(SolidInstance) / 16; ++i)
        describe(2 + i, 4, sizeof(SolidInstance), std::size_t{16} * i, 1);
    glBindVertexArray(marks_);
    glBindBuffer(GL_ARRAY_BUFFER, buffers_[3]);
    describe(0, 4, sizeof(MarkInstance), offsetof(MarkInstance, disc), 1);
    describe(1, 4, sizeof(MarkInstance), offsetof(MarkInstance, fill), 1);
    describe(2, 2, sizeof(MarkInstance), offsetof(MarkInstance, edge), 1);
    glBindVertexArray(0);
    glBindBuffer(GL_UNIFORM_BUFFER, buffers_[4]);
    glBufferData(GL_UNIFORM_BUFFER, kMostShading * kBoxFloats * sizeof(float), nullptr,
                 GL_STREAM_DRAW);
    grain_ = make_grain();
}

SpaceBuffers::~SpaceBuffers() {
    glDeleteTextures(1, &grain_);
    glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
    for (const GLuint array : {empty_, solids_, marks_})
        glDeleteVertexArrays(1, &array);
}

void SpaceBuffers::use_boxes(std::span<const float> boxes) const {
    glBindBuffer(GL_UNIFORM_BUFFER, buffers_[4]);
    glBufferSubData(GL_UNIFORM_BUFFER, 0, static_cast<GLsizeiptr>(boxes.size_bytes()),
                    boxes.data());
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffers_[4]);
}

void SpaceBuffers::fill(std::span<const SolidInstance> instances) const {
    fill_buffer(buffers_[2], instances, GL_STREAM_DRAW);
}

void SpaceBuffers::draw_solids(std::size_t count) const {
    glBindVertexArray(solids_);
    glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(mesh_.triangles.size()),
                            GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(count));
    glBindVertexArray(0);
}

void SpaceBuffers::draw_marks(std::span<const MarkInstance> marks) const {
    fill_buffer(buffers_[3], marks, GL_STREAM_DRAW);
    glBindVertexArray(marks_);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(marks.size()));
    glBindVertexArray(0);
}

void SpaceBuffers::draw_plain(GLenum form, GLsizei corners) const {
    glBindVertexArray(empty_);
    glDrawArrays(form, 0, corners);
    glBindVertexArray(0);
}

}  // namespace cambrian
