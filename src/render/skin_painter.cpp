// A pixel's distance to a skin is the smooth minimum of its distances to the boxes; the polynomial
//   min(a, b) = mix(b, a, h) - k h (1 - h),  h = clamp(1/2 + (b - a) / 2k)
// of Quilez reaches as far as the blend k. The inside is layered instead: a box in front covers
// those behind it. A box is shaded as a pillow: its normal leans outwards the more the nearer the
// edge.

#include "render/skin_painter.h"

#include "render/opengl/gl.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace cambrian {
namespace {

constexpr const char* kSkinVertexSource = R"(#version 330 core
layout(location = 0) in vec2 corner;  // px
uniform vec2 size;                    // px, of the target
void main() {
    gl_Position = vec4(2.0 * corner / size - 1.0, 0.0, 1.0);
}
)";

// After lines that define COUNT and, for light frames, LIGHT.
constexpr const char* kSkinFragmentSource = R"(
uniform vec2 origin;         // px, the target's corner
uniform vec4 place[COUNT];   // px: centre; cosine, sine
uniform vec4 extent[COUNT];  // px: half extents; phase, smaller half extent
uniform vec4 corner[COUNT];  // px: radii
uniform vec4 tint[COUNT];
uniform vec4 form;           // px: blend, outline, wave; pattern
uniform vec4 look;           // crease, flash, alpha, contrast of the pattern
uniform vec3 sun;
uniform vec3 halfway;  // between the sun and the viewer
uniform vec3 key;
uniform vec3 fill;
uniform vec3 rim;
uniform vec3 ink;
uniform vec4 lamp;           // px: place; 1 / reach squared, power
out vec4 color;

vec2 point;
float depth;    // signed distance to the outline, negative inside
float shade;    // of creases
vec2 lean;      // the normal's part in the picture's plane
vec3 base;
vec2 inside;    // the point in the frame of the box in front
float phase;

float box(int i, out vec2 at, out vec2 normal) {
    vec4 where = place[i];
    vec2 away = point - where.xy;
    at = vec2(dot(away, where.zw), dot(away, vec2(-where.w, where.z)));
    vec2 side = at.x > 0.0 ? corner[i].xz : corner[i].yw;
    float radius = at.y > 0.0 ? side.x : side.y;
    vec2 beyond = abs(at) - extent[i].xy + radius;
    float slope = extent[i].w;
    vec2 rise = sign(at) * clamp((abs(at) - extent[i].xy + slope) / slope, 0.0, 1.0);
    normal = vec2(dot(rise, vec2(where.z, -where.w)), dot(rise, where.wz));
    return length(max(beyond, 0.0)) + min(max(beyond.x, beyond.y), 0.0) - radius;
}

void begin() {
    depth = box(0, inside, lean);
    base = tint[0].rgb;
    phase = extent[0].z;
    shade = 1.0;
}

// Lays a box over those before it.
void cover(int i) {
    vec2 at;
    vec2 normal;
    float here = box(i, at, normal);
    float blend = form.x;
    float step = clamp(0.5 + 0.5 * (here - depth) / blend, 0.0, 1.0);
    float above = here - max(depth, 0.0);
    float over = clamp(0.5 - 0.5 * above / (0.3 * blend + 0.75), 0.0, 1.0);
    over = over * over * (3.0 - 2.0 * over);
    float near = max(0.0, 1.0 - max(above, 0.0) / (0.8 * blend));
    shade = mix(shade * (1.0 - 0.42 * look.x * near * near), 1.0, over);
    lean = mix(lean, normal, over);
    base = mix(base, tint[i].rgb, over);
    if (above < 0.0) {
        inside = at;
        phase = extent[i].z;
    }
    depth = mix(here, depth, step) - blend * step * (1.0 - step);
}

// Returns how dark the pattern is, 0 to 1.
float pattern() {
    float along = inside.x / form.z + phase;
    float across = inside.y / form.z;
    float sway = 0.10 * sin(across * 4.7 + phase * 5.0);
    float swing = sin(along * 6.28318);
    float wave = -1.0;
    if (form.w > 4.5) {
        wave = abs(fract(along - abs(across + 0.3 * sway) * 0.8) - 0.5) * 4.0 - 1.0;
    } else if (form.w > 3.5) {
        wave = (lean.y * 1.7 - 0.3 + 0.34 * swing + sway) * 3.0;
    } else if (form.w > 2.5) {
        wave = abs(fract(across * 1.35 + 0.25 + 0.06 * swing) - 0.5) * 4.0 - 1.0;
    } else if (form.w > 1.5) {
        float row = floor(across * 1.5 + 0.5);
        vec2 cell = vec2(fract(along * 1.5 + 0.5 * row) - 0.5, across * 1.5 - row);
        wave = (0.33 + 0.06 * swing - length(cell)) * 7.0;
    } else if (form.w > 0.5) {
        wave = abs(fract(along + sway) - 0.5) * 4.0 - 0.9;
    }
    float soft = 0.10 + 3.0 / form.z;
    return smoothstep(-soft, soft, wave);
}

void main() {
    point = gl_FragCoord.xy - origin;
    begin();
#if COUNT > 1
    cover(1);
#endif
#if COUNT > 2
    cover(2);
#endif
#if COUNT > 3
    cover(3);
#endif
    float steep = dot(lean, lean);
    lean *= steep > 1.0 ? inversesqrt(steep) : 1.0;
    steep = min(steep, 1.0);
    float up = sqrt(1.0 - 0.93 * steep);
    vec3 normal = vec3(0.964 * lean, up);

    float belly = smoothstep(0.10, 0.95, -lean.y);
    vec3 paint = base * (1.0 - look.w * pattern() * (1.0 - 0.85 * belly));
    float grey = dot(paint, vec3(0.3, 0.55, 0.15));
    paint = mix(paint, 0.45 * paint + vec3(0.30, 0.27, 0.23) + 0.2 * grey, 0.45 * belly);

    float facing = dot(normal, sun);
    vec3 light = fill * (0.74 + 0.26 * lean.y) + key * max(0.85 * facing + 0.15, 0.0);
    vec2 way = lamp.xy - point;
    float far = length(way);
    float glow = lamp.w / (1.0 + far * far * lamp.z);
    light += vec3(1.0, 0.82, 0.52) * glow *
             max(dot(normal, vec3(0.92 * way / max(far, 1.0), 0.40)), 0.0);
    vec3 lit = paint * light;
    float edge = 1.0 - up;
    lit += rim * edge * edge * clamp(lean.y + 0.35, 0.0, 1.0);
#ifndef LIGHT
    float gleam = max(dot(normal, halfway), 0.0);
    gleam *= gleam;
    gleam *= gleam;
    gleam *= gleam;
    gleam *= gleam;
    lit += key * 0.17 * gleam * gleam;
#endif
    lit *= shade;

    float line = clamp(0.5 + depth + form.y, 0.0, 1.0);
    lit = mix(lit, base * ink, 0.94 * line);
    lit = mix(lit, vec3(1.0, 0.30, 0.22), look.y * (0.30 + 1.70 * line));
    color = vec4(lit, clamp(0.5 - depth, 0.0, 1.0) * look.z);
}
)";

// Waves of fewer pixels fade, since they would only flicker.
constexpr double kClearWave = 9.0;
constexpr float kContrast = 0.30F;

float pixels(double metres, const Camera& camera) {
    return static_cast<float>(metres * camera.pixels_per_metre);
}

void give(int uniform, const Color& color) {
    glUniform3f(uniform, color.r, color.g, color.b);
}

void add_corners(std::vector<float>& corners, const SkinTile& tile) {
    const float right = tile.x + tile.width;
    const float top = tile.y + tile.height;
    corners.insert(corners.end(), {tile.x, tile.y, right, tile.y, right, top,  //
                                   tile.x, tile.y, right, top, tile.x, top});
}

}  // namespace

SkinPainter::Program::Program(Shader linked)
    : shader(std::move(linked)),
      origin(shader.uniform("origin")),
      size(shader.uniform("size")),
      place(shader.uniform("place")),
      extent(shader.uniform("extent")),
      corner(shader.uniform("corner")),
      tint(shader.uniform("tint")),
      form(shader.uniform("form")),
      look(shader.uniform("look")),
      sun(shader.uniform("sun")),
      halfway(shader.uniform("halfway")),
      key(shader.uniform("key")),
      fill(shader.uniform("fill")),
      rim(shader.uniform("rim")),
      ink(shader.uniform("ink")),
      lamp(shader.uniform("lamp")) {}

Result<SkinPainter> SkinPainter::create() {
    std::vector<Program> programs;
    for (const char* light : {"", "#define LIGHT\n"}) {
        for (std::size_t count = 1; count <= kTileBoxes; ++count) {
            const std::string source = std::string("#version 330 core\n") + light +
                                       "#define COUNT " + std::to_string(count) +
                                       kSkinFragmentSource;
            Result<Shader> shader = Shader::compile(kSkinVertexSource, source.c_str());
            if (!shader) return shader.error();
            programs.emplace_back(std::move(*shader));
        }
    }
    return SkinPainter(std::move(programs));
}

void SkinPainter::place_boxes(const SceneFrame& frame, const Skin& skin, const Camera& camera,
                              const PixelRect& target) {
    boxes_.clear();
    const Vec2 middle(0.5 * target.width, 0.5 * target.height);
    for (std::size_t i = 0; i < std::min(skin.boxes, kMostSkinBoxes); ++i) {
        const SkinBox& box = frame.skin_boxes[skin.first_box + i];
        const Vec2 at = middle + (box.center - camera.center) * camera.pixels_per_metre;
        TileBox placed;
        placed.x = static_cast<float>(at.x());
        placed.y = static_cast<float>(at.y());
        placed.cosine = static_cast<float>(std::cos(box.angle));
        placed.sine = static_cast<float>(std::sin(box.angle));
        placed.half_x = std::max(0.5F, pixels(box.half_extents.x(), camera));
        placed.half_y = std::max(0.5F, pixels(box.half_extents.y(), camera));
        const float narrow = std::min(placed.half_x, placed.half_y);
        for (std::size_t corner = 0; corner < placed.radii.size(); ++corner)
            placed.radii[corner] = narrow * box.roundness[corner];
        boxes_.push_back(placed);
    }
}

void SkinPainter::use(const Program& program, const SceneFrame& frame, const Skin& skin,
                      const Camera& camera, const PixelRect& target) const {
    const SkinLight& light = frame.light;
    program.shader.use();
    glUniform2f(program.origin, static_cast<float>(target.x), static_cast<float>(target.y));
    glUniform2f(program.size, static_cast<float>(target.width), static_cast<float>(target.height));
    const float wave = std::max(1.0F, pixels(skin.wave, camera));
    glUniform4f(program.form, std::max(0.5F, pixels(skin.blend, camera)),
                pixels(skin.outline_width, camera), wave, static_cast<float>(skin.pattern));
    const auto clear = static_cast<float>(kClearWave);
    glUniform4f(program.look, skin.crease, skin.flash, skin.alpha,
                kContrast * std::min(1.0F, wave / clear));
    const Vec3 sun = light.sun.normalized();
    glUniform3f(program.sun, static_cast<float>(sun.x()), static_cast<float>(sun.y()),
                static_cast<float>(sun.z()));
    const Vec3 halfway = (sun + Vec3::UnitZ()).normalized();
    glUniform3f(program.halfway, static_cast<float>(halfway.x()), static_cast<float>(halfway.y()),
                static_cast<float>(halfway.z()));
    give(program.key, light.key);
    give(program.fill, light.fill);
    give(program.rim, light.rim);
    give(program.ink, light.ink);
    const Vec2 lamp = Vec2(0.5 * target.width, 0.5 * target.height) +
                      (light.lamp - camera.center) * camera.pixels_per_metre;
    const float reach = pixels(light.lamp_reach, camera);
    glUniform4f(program.lamp, static_cast<float>(lamp.x()), static_cast<float>(lamp.y()),
                1.0F / (reach * reach), light.lamp_power);
}

void SkinPainter::give_boxes(const Program& program, const SceneFrame& frame, const Skin& skin,
                             const SkinTile& tile) const {
    constexpr std::size_t kRoom = 4 * kTileBoxes;
    std::array<float, kRoom> place{}, extent{}, corner{}, tint{};
    for (std::size_t i = 0; i < tile.count; ++i) {
        const TileBox& box = boxes_[tile.boxes[i]];
        const SkinBox& given = frame.skin_boxes[skin.first_box + tile.boxes[i]];
        const auto set = [i](std::array<float, kRoom>& values, const std::array<float, 4>& to) {
            std::copy(to.begin(), to.end(), values.begin() + static_cast<std::ptrdiff_t>(4 * i));
        };
        set(place, {box.x, box.y, box.cosine, box.sine});
        set(extent, {box.half_x, box.half_y, given.phase, std::min(box.half_x, box.half_y)});
        set(corner, box.radii);
        set(tint, {given.fill.r, given.fill.g, given.fill.b, 1.0F});
    }
    const auto count = static_cast<GLsizei>(tile.count);
    glUniform4fv(program.place, count, place.data());
    glUniform4fv(program.extent, count, extent.data());
    glUniform4fv(program.corner, count, corner.data());
    glUniform4fv(program.tint, count, tint.data());
}

void SkinPainter::draw(const SceneFrame& frame, const Skin& skin, const Camera& camera,
                       const PixelRect& target) {
    place_boxes(frame, skin, camera, target);
    tiles_.clear();
    add_skin_tiles(tiles_, boxes_, std::max(0.5F, pixels(skin.blend, camera)),
                   static_cast<float>(target.width), static_cast<float>(target.height));
    corners_.clear();
    for (const SkinTile& tile : tiles_)
        add_corners(corners_, tile);
    buffer_.fill(corners_);
    std::size_t first = 0;
    std::size_t used = 0;
    const std::size_t programs = frame.detail == Detail::kLight ? kTileBoxes : 0;
    while (first < tiles_.size()) {
        const SkinTile& tile = tiles_[first];
        std::size_t end = first + 1;
        while (end < tiles_.size() && tiles_[end].has_boxes_of(tile))
            ++end;
        const Program& program = programs_[programs + tile.count - 1U];
        if (used != tile.count) use(program, frame, skin, camera, target);
        used = tile.count;
        give_boxes(program, frame, skin, tile);
        buffer_.draw(first, end - first);
        first = end;
    }
}

}  // namespace cambrian
