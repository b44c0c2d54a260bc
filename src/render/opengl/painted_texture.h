#pragma once

#include "core/result.h"

namespace cambrian {

// A texture that is drawn into, then drawn from or copied. It repeats from left to right. Needs a
// current OpenGL context throughout its lifetime.
class PaintedTexture {
public:
    // Whether what is drawn later may be behind what is there.
    enum class Depth : unsigned char { kNone, kKept };

    // The size is in texels, each way from 1 up.
    static Result<PaintedTexture> create(int width, int height, Depth depth = Depth::kNone);
    ~PaintedTexture();
    PaintedTexture(PaintedTexture&& other) noexcept;
    PaintedTexture& operator=(PaintedTexture&& other) noexcept;

    void bind_to_draw() const;    // draws into all of it until another framebuffer is bound
    void bind_to_copy() const;    // as the source of copies between framebuffers
    void bind_to_sample() const;  // as the texture of shaders
    unsigned name() const { return texture_; }  // of the texture in OpenGL; bottom row first
    int width() const { return width_; }
    int height() const { return height_; }

private:
    PaintedTexture() = default;

    unsigned framebuffer_ = 0;
    unsigned texture_ = 0;
    unsigned depth_ = 0;
    int width_ = 0;
    int height_ = 0;
};

}  // namespace cambrian
