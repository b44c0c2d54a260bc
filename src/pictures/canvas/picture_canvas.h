#pragma once

// A picture being drawn: shapes on a background, scenes on top, and text above all. Positions are
// in pixels from the top left, y down.

#include "core/image.h"
#include "core/result.h"
#include "pictures/canvas/palette.h"
#include "pictures/canvas/text_rasterizer.h"
#include "render/opengl/framebuffer.h"
#include "render/renderer.h"

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cambrian {

struct Area {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;

    double right() const { return x + width; }
    double bottom() const { return y + height; }
    // Returns the area reduced by so many pixels on every side.
    Area inset(double by) const { return {x + by, y + by, width - 2.0 * by, height - 2.0 * by}; }
};

struct Ink {
    Typeface typeface = Typeface::kRegular;
    double size = 15.0;  // height of a line, in pixels
    Color color = {};
};

enum class Align : unsigned char { kLeft, kMiddle, kRight };

class PictureCanvas {
public:
    // Both references must outlive the object; their OpenGL context must be current. Fails if the
    // driver cannot make a picture of this size.
    static Result<PictureCanvas> create(Renderer& renderer, const TextRasterizer& text_rasterizer,
                                        int width, int height);

    int width() const { return framebuffer_.width(); }
    int height() const { return framebuffer_.height(); }
    const TextRasterizer& text_rasterizer() const { return *text_rasterizer_; }

    // Fills the picture with one colour.
    void clear(const Color& background);
    void add_box(const Area& area, double radius, const Color& fill);
    void add_line(const Vec2& from, const Vec2& to, double width, const Color& color);
    // Draws a scene in a rectangle of full pixels, over all boxes.
    void add_scene(SceneFrame frame, const Camera& camera, const Area& area);
    // Changes the picture when all scenes are drawn, in the order of the calls.
    void add_touch(std::function<void(Image&)> touch) { touches_.push_back(std::move(touch)); }
    // Paints the area outside the rounded corners of a rectangle, below all text.
    void round_corners(const Area& area, double radius, const Color& around);
    // Draws text with its baseline at y. If `most` is greater than 0, the text is shortened to that
    // width.
    void add_text(double x, double y, std::string_view text, const Ink& ink,
                  Align align = Align::kLeft, double most = 0.0);
    Image finish();

private:
    PictureCanvas(Renderer& renderer, const TextRasterizer& text_rasterizer,
                  Framebuffer framebuffer)
        : renderer_(&renderer),
          text_rasterizer_(&text_rasterizer),
          framebuffer_(std::move(framebuffer)) {}

    Renderer* renderer_;
    const TextRasterizer* text_rasterizer_;
    Framebuffer framebuffer_;
    SceneFrame boxes_;  // one metre of the frame is one pixel
    struct Scene {
        SceneFrame frame;
        Camera camera;
        PixelRect place;
    };
    std::vector<Scene> scenes_;
    std::vector<std::function<void(Image&)>> touches_;  // changes to the finished image, made last
};

}  // namespace cambrian
