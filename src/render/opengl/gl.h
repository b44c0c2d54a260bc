#pragma once

// Includes the OpenGL loader. No other file includes it.
#include <glad/gl.h>
