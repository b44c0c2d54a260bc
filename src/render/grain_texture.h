#pragma once

#include "render/opengl/gl.h"

namespace cambrian {

// Makes a texture that repeats: uneven colour in its red, a net of light, as waves cast it, in its
// green channel. Needs a current OpenGL context; the caller deletes it.
GLuint make_grain();

}  // namespace cambrian
