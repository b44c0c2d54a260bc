#include "pictures/canvas/picture_canvas.h"

#include "render/opengl/gl.h"
#include "render/opengl/pixels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

// Converts from an origin at the top left, y down, to the renderer's lower left, y up.
PixelRect pixels_of(const Area& area, int height) {
    const auto whole = [](double pixels) { return static_cast<int>(std::lround(pixels)); };
    return {whole(area.x), height - whole(area.bottom()), whole(area.right()) - whole(area.x),
            whole(area.bottom()) - whole(area.y)};
}

void mix_into(std::uint8_t* pixel, const Color& color, double share) {
    const std::array<float, 3> target = {color.r, color.g, color.b};
    for (std::size_t i = 0; i < target.size(); ++i) {
        const double mixed =
            (1.0 - share) * pixel[i] + share * 255.0 * static_cast<double>(target[i]);
        pixel[i] = static_cast<std::uint8_t>(std::lround(mixed));
    }
}

// Returns the share of a pixel outside a rounded corner; x, y is relative to the corner's centre.
double share_outside(double x, double y, double radius) {
    return std::clamp(std::hypot(x, y) - radius + 0.5, 0.0, 1.0);
}

void paint_corners(Image& image, const Area& area, double radius, const Color& around) {
    const int reach = static_cast<int>(std::ceil(radius));
    const int left = static_cast<int>(std::lround(area.x));
    const int right = static_cast<int>(std::lround(area.right())) - 1;
    const int top = static_cast<int>(std::lround(area.y));
    const int bottom = static_cast<int>(std::lround(area.bottom())) - 1;
    for (int y = 0; y < reach; ++y) {
        for (int x = 0; x < reach; ++x) {
            const double share = share_outside(radius - x - 0.5, radius - y - 0.5, radius);
            for (const int column : {left + x, right - x}) {
                for (const int row : {top + y, bottom - y}) {
                    const bool inside =
                        column >= 0 && column < image.width && row >= 0 && row < image.height;
                    if (inside) mix_into(image.pixel(column, row), around, share);
                }
            }
        }
    }
}

}  // namespace

Result<PictureCanvas> PictureCanvas::create(Renderer& renderer,
                                            const TextRasterizer& text_rasterizer, int width,
                                            int height) {
    auto framebuffer = Framebuffer::create(width, height);
    if (!framebuffer) return framebuffer.error();
    return PictureCanvas(renderer, text_rasterizer, std::move(*framebuffer));
}

void PictureCanvas::clear(const Color& background) {
    boxes_.clear();
    scenes_.clear();
    touches_.clear();
    boxes_.background = background;
}

void PictureCanvas::add_box(const Area& area, double radius, const Color& fill) {
    boxes_.shapes.push_back({.center = {area.x + 0.5 * area.width, -area.y - 0.5 * area.height},
                             .half_extents = {0.5 * area.width, 0.5 * area.height},
                             .radius = radius,
                             .fill = fill});
}

void PictureCanvas::add_line(const Vec2& from, const Vec2& to, double width, const Color& color) {
    boxes_.add_line({from.x(), -from.y()}, {to.x(), -to.y()}, width, color);
}

void PictureCanvas::add_scene(SceneFrame frame, const Camera& camera, const Area& area) {
    scenes_.push_back({std::move(frame), camera, pixels_of(area, height())});
}

void PictureCanvas::round_corners(const Area& area, double radius, const Color& around) {
    touches_.emplace_back(
        [area, radius, around](Image& image) { paint_corners(image, area, radius, around); });
}

void PictureCanvas::add_text(double x, double y, std::string_view text, const Ink& ink, Align align,
                             double most) {
    std::string words(text);
    if (most > 0.0) words = text_rasterizer_->fit(text, ink.typeface, ink.size, most);
    const double width = text_rasterizer_->width(words, ink.typeface, ink.size);
    if (align == Align::kMiddle) x -= 0.5 * width;
    if (align == Align::kRight) x -= width;
    touches_.emplace_back(
        [letters = text_rasterizer_, x, y, ink, words = std::move(words)](Image& image) {
            letters->draw(image, x, y, words, ink.typeface, ink.size, ink.color);
        });
}

Image PictureCanvas::finish() {
    framebuffer_.bind();
    Camera camera;
    camera.pixels_per_metre = 1.0;
    camera.center = {0.5 * width(), -0.5 * height()};
    renderer_->draw(boxes_, camera, {0, 0, width(), height()});
    for (const Scene& scene : scenes_)
        renderer_->draw(scene.frame, scene.camera, scene.place);
    Image image = read_pixels(width(), height());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    for (const auto& touch : touches_)
        touch(image);
    return image;
}

}  // namespace cambrian
