#include "render/opengl/painted_texture.h"

#include "render/opengl/gl.h"

#include <fmt/core.h>

#include <utility>

namespace cambrian {

Result<PaintedTexture> PaintedTexture::create(int width, int height, Depth depth) {
    PaintedTexture result;
    result.width_ = width;
    result.height_ = height;
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    const Error refused{
        fmt::format("the graphics driver has no texture of {} x {} texels", width, height)};
    if (width > most || height > most) return refused;
    glGenTextures(1, &result.texture_);
    result.bind_to_sample();
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glGenFramebuffers(1, &result.framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, result.framebuffer_);
    glFramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                           result.texture_, 0);
    if (depth == Depth::kKept) {
        glGenRenderbuffers(1, &result.depth_);
        glBindRenderbuffer(GL_RENDERBUFFER, result.depth_);
        glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
        glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                  result.depth_);
    }
    if (glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return refused;
    return result;
}

PaintedTexture::PaintedTexture(PaintedTexture&& other) noexcept
    : framebuffer_(std::exchange(other.framebuffer_, 0)),
      texture_(std::exchange(other.texture_, 0)),
      depth_(std::exchange(other.depth_, 0)),
      width_(other.width_),
      height_(other.height_) {}

PaintedTexture& PaintedTexture::operator=(PaintedTexture&& other) noexcept {
    std::swap(framebuffer_, other.framebuffer_);
    std::swap(texture_, other.texture_);
    std::swap(depth_, other.depth_);
    width_ = other.width_;
    height_ = other.height_;
    return *this;
}

PaintedTexture::~PaintedTexture() {
    if (framebuffer_ != 0) glDeleteFramebuffers(1, &framebuffer_);
    if (texture_ != 0) glDeleteTextures(1, &texture_);
    if (depth_ != 0) glDeleteRenderbuffers(1, &depth_);
}

void PaintedTexture::bind_to_draw() const {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_);
    glViewport(0, 0, width_, height_);
}

void PaintedTexture::bind_to_copy() const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
}

void PaintedTexture::bind_to_sample() const {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture_);
}

}  // namespace cambrian
