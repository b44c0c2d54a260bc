#pragma once

#include "core/result.h"

#include <memory>

namespace cambrian {

// An OpenGL 3.3 context without window or display, made by EGL. It is current on the thread that
// created it. Drawing needs a Framebuffer.
class OffscreenContext {
public:
    // Fails if the graphics driver offers no such context.
    static Result<std::unique_ptr<OffscreenContext>> create();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

private:
    OffscreenContext() = default;

    void* display_ = nullptr;  // EGL handles; null for none
    void* surface_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace cambrian
