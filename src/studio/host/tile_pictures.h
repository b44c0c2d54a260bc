#pragma once

// Pictures of living bodies at rest, drawn once into textures and kept. Many share one texture, so
// that a list of tiles is drawn at once.

#include "render/opengl/painted_texture.h"
#include "render/renderer.h"
#include "studio/look/ui_context.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace cambrian {

struct CreatureLook;

// Needs a current context of OpenGL, also at its end.
class TilePictures {
public:
    // The renderer must outlive the object.
    explicit TilePictures(Renderer& renderer) : renderer_(renderer) {}

    // Returns a picture, drawn now if it was never asked for or was given up since. Nothing if it
    // is too large. Pictures that were not asked for lately are given up for others. That of a
    // moment is drawn each time, and the next one but one replaces it.
    std::optional<TilePicture> of(const TileWish& wish);

private:
    // All that the picture of a wish depends on.
    struct Key {
        std::uint64_t body = 0;
        std::uint64_t line = 0;
        double hue = 0.0;
        int width = 0;
        int height = 0;
        bool plain = false;  // as boxes, where a body in space is drawn so

        auto operator<=>(const Key&) const = default;  // NOLINT(modernize-use-nullptr)
    };
    // A texture divided into cells of one size.
    struct Page {
        PaintedTexture texture;
        int width = 1;  // pixels; of a cell
        int height = 1;
        std::size_t used = 0;     // cells
        std::uint64_t asked = 0;  // number of the last wish for one of its pictures

        std::size_t columns() const;
        std::size_t cells() const;
    };
    struct Place {
        std::size_t page = 0;
        std::size_t cell = 0;
    };
    static Key key_of(const TileWish& wish);
    std::optional<std::size_t> page_for(int width, int height);
    void paint(const TileWish& wish, const Place& place);
    std::optional<TilePicture> moving(const TileWish& wish);
    // Draws a body into a rectangle of a texture.
    void draw(const TileWish& wish, std::span<const Pose> poses, const Camera& camera,
              const PaintedTexture& texture, const PixelRect& target);
    void draw_in_space(const TileWish& wish, CreatureLook& look, const Camera& camera,
                       const PaintedTexture& texture, const PixelRect& target);

    Renderer& renderer_;
    std::vector<Page> pages_;
    std::map<Key, Place> places_;
    std::uint64_t wishes_ = 0;
    // Used in turn: where a texture stays the same, the window is not painted anew.
    std::array<std::optional<PaintedTexture>, 2> moving_;
    std::size_t turn_ = 0;
};

}  // namespace cambrian
