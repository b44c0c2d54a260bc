// A rounded box of half extents h and corner radius r has the signed distance
//   d(p) = |max(|p| - h + r, 0)| + min(max(|p| - h + r), 0) - r
// from a point p in its own frame (Quilez). Coverage of a pixel of size s is 1/2 - d/s, clamped.

#include "render/renderer.h"

#include "render/filled_rect.h"
#include "render/opengl/gl.h"

#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr const char* kVertexSource = R"(#version 330 core
layout(location = 0) in vec4 box;      // centre, half extents; m
layout(location = 1) in vec2 turn;     // cosine, sine
layout(location = 2) in vec3 edge;     // radius, outline width, blur; m
layout(location = 3) in vec4 fill;
layout(location = 4) in vec4 outline;
uniform vec2 scale;    // clip units per metre
uniform float pixel;   // m
out vec2 point;
flat out vec2 half_extents;
flat out vec3 rim;
flat out vec4 inside;
flat out vec4 border;
void main() {
    vec2 corner = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1);
    point = corner * (box.zw + vec2(pixel + edge.z));
    vec2 world = box.xy + vec2(turn.x * point.x - turn.y * point.y,
                               turn.y * point.x + turn.x * point.y);
    gl_Position = vec4(world * scale, 0.0, 1.0);
    half_extents = box.zw;
    rim = edge;
    inside = fill;
    border = outline;
}
)";

constexpr const char* kFragmentSource = R"(#version 330 core
in vec2 point;
flat in vec2 half_extents;
flat in vec3 rim;
flat in vec4 inside;
flat in vec4 border;
uniform float pixel;
out vec4 color;
void main() {
    vec2 beyond = abs(point) - half_extents + rim.x;
    float distance = length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - rim.x;
    float soft = max(pixel, 2.0 * rim.z);
    float coverage = clamp(0.5 - distance / soft, 0.0, 1.0);
    float on_border = rim.y > 0.0 ? clamp(0.5 + (distance + rim.y) / pixel, 0.0, 1.0) : 0.0;
    vec4 paint = mix(inside, border, on_border);
    color = vec4(paint.rgb, paint.a * coverage);
}
)";

// pixels around a shape that still count as visible
constexpr double kMargin = 2.0;

bool visible(const Shape& shape, const WorldWindow& window, double pixel) {
    const double reach = shape.half_extents.norm() + shape.blur + kMargin * pixel;
    return shape.center.x() + reach > window.low.x() &&
           shape.center.x() - reach < window.high.x() &&
           shape.center.y() + reach > window.low.y() && shape.center.y() - reach < window.high.y();
}

// Lines and dots thinner than a pixel would flicker, so they are drawn one pixel wide and fainter.
ShapeInstance instance_of(const Shape& shape, const Camera& camera) {
    const Vec2 at = shape.center - camera.center;
    const double least = 0.5 * camera.pixel();
    ShapeInstance instance;
    instance.center_x = static_cast<float>(at.x());
    instance.center_y = static_cast<float>(at.y());
    instance.half_x = static_cast<float>(std::fmax(shape.half_extents.x(), least));
    instance.half_y = static_cast<float>(std::fmax(shape.half_extents.y(), least));
    instance.cosine = static_cast<float>(std::cos(shape.angle));
    instance.sine = static_cast<float>(std::sin(shape.angle));
    instance.radius = static_cast<float>(shape.radius);
    instance.outline_width = static_cast<float>(shape.outline_width);
    instance.blur = static_cast<float>(shape.blur);
    instance.fill = pack(shape.fill);
    instance.outline = pack(shape.outline);
    return instance;
}

// Fills the boxes with which a frame begins and returns their number. Ground and grid are most of
// what is painted, and software renderers fill rectangles many times faster than they run a shader.
std::size_t fill_boxes(std::span<const Shape> shapes, const Camera& camera,
                       const PixelRect& target) {
    std::size_t count = 0;
    for (; count < shapes.size(); ++count) {
        const auto pixels = pixels_of_box(shapes[count], camera, target);
        if (!pixels) break;
        fill_rect(*pixels, shapes[count].fill);
    }
    return count;
}

}  // namespace

Result<std::unique_ptr<Renderer>> Renderer::create() {
    Result<Shader> shader = Shader::compile(kVertexSource, kFragmentSource);
    if (!shader) return shader.error();
    Result<SkinPainter> skin_painter = SkinPainter::create();
    if (!skin_painter) return skin_painter.error();
    Result<BackdropPainter> backdrop_painter = BackdropPainter::create();
    if (!backdrop_painter) return backdrop_painter.error();
    Result<SpacePainter> space_painter = SpacePainter::create();
    if (!space_painter) return space_painter.error();
    return std::unique_ptr<Renderer>(new Renderer(std::move(*shader), std::move(*skin_painter),
                                                  std::move(*backdrop_painter),
                                                  std::move(*space_painter)));
}

Renderer::Renderer(Shader shader, SkinPainter skin_painter, BackdropPainter backdrop_painter,
                   SpacePainter space_painter)
    : shader_(std::move(shader)),
      skin_painter_(std::move(skin_painter)),
      backdrop_painter_(std::move(backdrop_painter)),
      space_painter_(std::move(space_painter)) {
    scale_uniform_ = shader_.uniform("scale");
    pixel_uniform_ = shader_.uniform("pixel");
}

void Renderer::collect(std::span<const Shape> shapes, const Camera& camera,
                       const Viewport& viewport) {
    const WorldWindow window = camera.window(viewport);
    instances_.clear();
    for (const Shape& shape : shapes) {
        if (visible(shape, window, camera.pixel()))
            instances_.push_back(instance_of(shape, camera));
    }
}

void Renderer::draw_shapes(std::span<const Shape> shapes, const Camera& camera,
                           const Viewport& viewport) {
    collect(shapes, camera, viewport);
    if (instances_.empty()) return;
    shader_.use();
    glUniform2f(scale_uniform_, static_cast<float>(2.0 * camera.pixels_per_metre / viewport.width),
                static_cast<float>(2.0 * camera.pixels_per_metre / viewport.height));
    glUniform1f(pixel_uniform_, static_cast<float>(camera.pixel()));
    buffer_.fill(instances_);
    buffer_.draw();
}

void Renderer::draw(const SceneFrame& frame, const Camera& camera, const PixelRect& target,
                    Baking baking) {
    const Viewport viewport{static_cast<double>(target.width), static_cast<double>(target.height)};
    glViewport(target.x, target.y, target.width, target.height);
    if (frame.space != nullptr) {
        space_painter_.draw(*frame.space, target);
        glViewport(target.x, target.y, target.width, target.height);
    } else if (frame.backdrop != nullptr) {
        backdrop_painter_.draw(*frame.backdrop, frame.ground, camera, target, baking);
    } else {
        fill_rect(target, frame.background);
    }
    const std::span<const Shape> shapes = frame.shapes;
    const std::size_t lowest =
        frame.skins.empty() ? shapes.size() : frame.skins.front().shapes_below;
    std::size_t drawn = fill_boxes(shapes.first(lowest), camera, target);
    glScissor(target.x, target.y, target.width, target.height);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (const Skin& skin : frame.skins) {
        draw_shapes(shapes.subspan(drawn, skin.shapes_below - drawn), camera, viewport);
        drawn = skin.shapes_below;
        skin_painter_.draw(frame, skin, camera, target);
    }
    draw_shapes(shapes.subspan(drawn), camera, viewport);
}

}  // namespace cambrian
