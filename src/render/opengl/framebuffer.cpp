#include "render/opengl/framebuffer.h"

#include "render/opengl/gl.h"

#include <fmt/core.h>

#include <string>
#include <utility>

namespace cambrian {

Result<Framebuffer> Framebuffer::create(int width, int height) {
    Framebuffer result;
    result.width_ = width;
    result.height_ = height;
    glGenFramebuffers(1, &result.framebuffer_);
    glGenRenderbuffers(1, &result.color_);
    glBindRenderbuffer(GL_RENDERBUFFER, result.color_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, result.framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, result.color_);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (status == GL_FRAMEBUFFER_COMPLETE) return result;
    return Error{
        fmt::format("the graphics driver cannot make a picture of {} x {} pixels", width, height)};
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept
    : framebuffer_(std::exchange(other.framebuffer_, 0)),
      color_(std::exchange(other.color_, 0)),
      width_(other.width_),
      height_(other.height_) {}

Framebuffer::~Framebuffer() {
    if (framebuffer_ != 0) glDeleteFramebuffers(1, &framebuffer_);
    if (color_ != 0) glDeleteRenderbuffers(1, &color_);
}

void Framebuffer::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

}  // namespace cambrian
