#pragma once

#include "core/result.h"

#include <memory>

namespace cambrian {

// OpenGL 3.3 without a window or a display, through EGL; current on the thread that made it. Draw
// into a Framebuffer.
class OffscreenContext {
public:
    // Fails, saying so, where the graphics driver offers none.
    static Result<std::unique_ptr<OffscreenContext>> create();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

private:
    OffscreenContext() = default;

    void* display_ = nullptr;  // EGL's handles; null for none
    void* surface_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace cambrian
