#include "studio/host/textures.h"

#include "render/opengl/gl.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace cambrian {
namespace {

// Smaller copies of the picture keep it smooth where it is drawn smaller.
GLuint texture_with_copies(const Image& picture) {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture.width, picture.height, 0, GL_RGB,
                 GL_UNSIGNED_BYTE, picture.rgb.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glBindTexture(GL_TEXTURE_2D, 0);
    return texture;
}

}  // namespace

Textures::~Textures() {
    for (const Kept& each : kept_)
        glDeleteTextures(1, &each.texture);
}

ImTextureID Textures::of(const std::shared_ptr<const Image>& picture) {
    auto found = std::find_if(kept_.begin(), kept_.end(),
                              [&](const Kept& each) { return each.picture == picture; });
    if (found == kept_.end()) found = kept_.insert(found, {picture, texture_with_copies(*picture)});
    return std::bit_cast<ImTextureID>(std::uintptr_t{found->texture});
}

}  // namespace cambrian
