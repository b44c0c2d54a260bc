#pragma once

// Uniforms of the shader in use.

#include "render/color.h"
#include "render/opengl/gl.h"
#include "render/opengl/shader.h"

#include <array>

namespace cambrian {

inline void give(const Shader& shader, const char* name, const Color& color) {
    glUniform3f(shader.uniform(name), color.r, color.g, color.b);
}
inline void give(const Shader& shader, const char* name, int value) {
    glUniform1i(shader.uniform(name), value);
}
inline void give(const Shader& shader, const char* name, double value) {
    glUniform1f(shader.uniform(name), static_cast<float>(value));
}
inline void give(const Shader& shader, const char* name, double a, double b) {
    glUniform2f(shader.uniform(name), static_cast<float>(a), static_cast<float>(b));
}
inline void give(const Shader& shader, const char* name, double a, double b, double c) {
    glUniform3f(shader.uniform(name), static_cast<float>(a), static_cast<float>(b),
                static_cast<float>(c));
}

inline void give(const Shader& shader, const char* name, const std::array<float, 3>& three) {
    glUniform3f(shader.uniform(name), three[0], three[1], three[2]);
}
inline void give(const Shader& shader, const char* name, const std::array<double, 4>& four) {
    glUniform4f(shader.uniform(name), static_cast<float>(four[0]), static_cast<float>(four[1]),
                static_cast<float>(four[2]), static_cast<float>(four[3]));
}
// Sixteen numbers are a matrix, column by column.
inline void give(const Shader& shader, const char* name, const std::array<float, 16>& matrix) {
    glUniformMatrix4fv(shader.uniform(name), 1, GL_FALSE, matrix.data());
}

}  // namespace cambrian
