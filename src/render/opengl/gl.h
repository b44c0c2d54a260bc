#pragma once

// The only include of the OpenGL loader.
#include <glad/gl.h>
