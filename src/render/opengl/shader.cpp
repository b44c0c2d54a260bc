#include "render/opengl/shader.h"

#include "render/opengl/gl.h"

#include <array>
#include <string>

namespace cambrian {
namespace {

// Compiles a shader stage. On failure, returns 0 and sets `log` to the driver's message.
GLuint compile_stage(GLenum type, const char* source, std::string& log) {
    const GLuint stage = glCreateShader(type);
    glShaderSource(stage, 1, &source, nullptr);
    glCompileShader(stage);
    GLint compiled = GL_FALSE;
    glGetShaderiv(stage, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return stage;
    std::array<char, 1024> text{};
    glGetShaderInfoLog(stage, static_cast<GLsizei>(text.size()), nullptr, text.data());
    log += text.data();
    glDeleteShader(stage);
    return 0;
}

}  // namespace

Result<Shader> Shader::compile(const char* vertex_source, const char* fragment_source) {
    std::string log;
    const GLuint vertex = compile_stage(GL_VERTEX_SHADER, vertex_source, log);
    const GLuint fragment = compile_stage(GL_FRAGMENT_SHADER, fragment_source, log);
    const GLuint program = glCreateProgram();
    if (vertex != 0 && fragment != 0) {
        glAttachShader(program, vertex);
        glAttachShader(program, fragment);
        glLinkProgram(program);
    }
    glDeleteShader(vertex);
    glDeleteShader(fragment);
    GLint linked = GL_FALSE;
    if (vertex != 0 && fragment != 0) glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return Shader(program);
    glDeleteProgram(program);
    return Error{"the graphics driver refused a shader: " + log};
}

Shader::~Shader() {
    if (program_ != 0) glDeleteProgram(program_);
}

void Shader::use() const {
    glUseProgram(program_);
}

void Shader::use_block(const char* name, unsigned place) const {
    glUniformBlockBinding(program_, glGetUniformBlockIndex(program_, name), place);
}

int Shader::uniform(const char* name) const {
    return glGetUniformLocation(program_, name);
}

}  // namespace cambrian
