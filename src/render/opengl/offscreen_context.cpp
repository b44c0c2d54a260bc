#include "render/opengl/offscreen_context.h"

#include "render/opengl/gl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <array>
#include <string>
#include <string_view>

namespace cambrian {
namespace {

bool offers(const char* extensions, std::string_view name) {
    return extensions != nullptr &&
           std::string_view(extensions).find(name) != std::string_view::npos;
}

// Returns Mesa's surfaceless display; with other drivers, their default display.
EGLDisplay find_display() {
    if (offers(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless")) {
        const EGLDisplay display =
            eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
        if (display != EGL_NO_DISPLAY) return display;
    }
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

EGLConfig find_config(EGLDisplay display) {
    constexpr std::array<EGLint, 9> wanted = {EGL_SURFACE_TYPE,
                                              EGL_PBUFFER_BIT,
                                              EGL_RENDERABLE_TYPE,
                                              EGL_OPENGL_BIT,
                                              EGL_RED_SIZE,
                                              8,
                                              EGL_GREEN_SIZE,
                                              8,
                                              EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &count) != EGL_TRUE || count == 0)
        return nullptr;
    return config;
}

EGLContext create_context(EGLDisplay display, EGLConfig config) {
    constexpr std::array<EGLint, 7> wanted = {EGL_CONTEXT_MAJOR_VERSION,
                                              3,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              3,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, wanted.data());
}

// Creates a surface that is never drawn to, since some drivers require one.
EGLSurface create_surface(EGLDisplay display, EGLConfig config) {
    if (offers(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
        return EGL_NO_SURFACE;
    constexpr std::array<EGLint, 5> size = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    return eglCreatePbufferSurface(display, config, size.data());
}

Error failure(const char* what) {
    return Error{std::string("no OpenGL 3.3 to draw pictures with: ") + what};
}

}  // namespace

Result<std::unique_ptr<OffscreenContext>> OffscreenContext::create() {
    std::unique_ptr<OffscreenContext> result(new OffscreenContext);
    const EGLDisplay display = find_display();
    if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) != EGL_TRUE)
        return failure("EGL finds no graphics driver");
    result->display_ = display;
    if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return failure("EGL offers no OpenGL");
    const EGLConfig config = find_config(display);
    if (config == nullptr) return failure("EGL offers no pictures of 24 bits");
    result->context_ = create_context(display, config);
    if (result->context_ == EGL_NO_CONTEXT) return failure("the graphics driver is too old");
    result->surface_ = create_surface(display, config);
    if (eglMakeCurrent(display, result->surface_, result->surface_, result->context_) != EGL_TRUE)
        return failure("EGL does not let it be used");
    // The functions are the same for every context; those of a window may be in use.
    if (glad_glGetString == nullptr && gladLoadGL(eglGetProcAddress) == 0)
        return failure("its functions are missing");
    return result;
}

OffscreenContext::~OffscreenContext() {
    if (display_ == nullptr) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface_ != nullptr) eglDestroySurface(display_, surface_);
    if (context_ != nullptr) eglDestroyContext(display_, context_);
    eglTerminate(display_);
}

}  // namespace cambrian
