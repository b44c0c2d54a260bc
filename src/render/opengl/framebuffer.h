#pragma once

#include "core/result.h"

namespace cambrian {

// An off-screen framebuffer. Needs a current OpenGL context throughout its lifetime.
class Framebuffer {
public:
    static Result<Framebuffer> create(int width, int height);
    ~Framebuffer();
    Framebuffer(Framebuffer&& other) noexcept;
    Framebuffer& operator=(Framebuffer&&) = delete;

    void bind() const;  // binds it until another framebuffer, or 0, is bound
    int width() const { return width_; }
    int height() const { return height_; }

private:
    Framebuffer() = default;

    unsigned framebuffer_ = 0;
    unsigned color_ = 0;
    int width_ = 0;
    int height_ = 0;
};

}  // namespace cambrian
