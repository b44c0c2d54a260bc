#include "render/filled_rect.h"

#include "render/opengl/gl.h"

namespace cambrian {

void fill_rect(const PixelRect& pixels, const Color& color) {
    if (pixels.width <= 0 || pixels.height <= 0) return;
    glEnable(GL_SCISSOR_TEST);
    glScissor(pixels.x, pixels.y, pixels.width, pixels.height);
    glClearColor(color.r, color.g, color.b, color.a);
    glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace cambrian
