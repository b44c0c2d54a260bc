#pragma once

#include "render/opengl/gl.h"

namespace cambrian {

// The bound framebuffers, bound again at the end.
class KeptFramebuffers {
public:
    KeptFramebuffers() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    }
    ~KeptFramebuffers() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    }
    KeptFramebuffers(const KeptFramebuffers&) = delete;
    KeptFramebuffers& operator=(const KeptFramebuffers&) = delete;

private:
    GLint draw_ = 0;
    GLint read_ = 0;
};

}  // namespace cambrian
