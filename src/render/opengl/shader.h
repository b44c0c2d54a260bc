#pragma once

#include "core/result.h"

namespace cambrian {

// A linked program of a vertex and a fragment shader. Needs a current OpenGL context throughout its
// lifetime.
class Shader {
public:
    static Result<Shader> compile(const char* vertex_source, const char* fragment_source);
    ~Shader();
    Shader(Shader&& other) noexcept : program_(other.program_) { other.program_ = 0; }
    Shader& operator=(Shader&&) = delete;

    void use() const;
    int uniform(const char* name) const;
    // Lets a block of uniforms read the buffer that is bound at a place.
    void use_block(const char* name, unsigned place) const;

private:
    explicit Shader(unsigned program) : program_(program) {}

    unsigned program_ = 0;
};

}  // namespace cambrian
