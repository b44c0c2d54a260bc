#include "render/space_painter.h"

#include "render/filled_rect.h"
#include "render/opengl/gl.h"
#include "render/space_seen.h"
#include "render/space_shaders.h"
#include "render/uniforms.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace cambrian {
namespace {

constexpr int kShadowSide = 96;     // texels
constexpr double kPenumbra = 0.30;  // width of a shadow's edge, in metres a metre of its height

enum : std::size_t { kSky, kShadow, kShaded, kInk, kMark, kSmooth };  // places of shaders
// Features of floors.
constexpr std::size_t kGrainy = 1;
constexpr std::size_t kRippled = 2;
constexpr std::size_t kLined = 4;

Result<Shader> compile(std::initializer_list<const char*> vertex,
                       std::initializer_list<const char*> fragment) {
    std::string first = space_shader::kVersion;
    for (const char* part : vertex)
        first += part;
    std::string second = space_shader::kVersion;
    for (const char* part : fragment)
        second += part;
    return Shader::compile(first.c_str(), second.c_str());
}

Result<Shader> compile_floor(std::size_t features) {
    using namespace space_shader;
    const auto given = [features](std::size_t feature, const char* name) {
        return (features & feature) != 0 ? name : "";
    };
    return compile({kFloorVertex},
                   {given(kGrainy, "#define GRAIN\n"), given(kRippled, "#define RIPPLES\n"),
                    given(kLined, "#define LINES\n"), kAround, kFloorFragment});
}

Result<Shader> compile_solid(std::size_t pattern) {
    using namespace space_shader;
    const std::string given = "#define PATTERN " + std::to_string(pattern) + "\n";
    return compile({kSolidVertex}, {given.c_str(), kAround, kBoxes, kSolidFragment});
}

}  // namespace

Result<SpacePainter> SpacePainter::create() {
    using namespace space_shader;
    std::vector<Shader> shaders;
    Status well;
    const auto add = [&](Result<Shader> shader) {
        if (shader) {
            shaders.push_back(std::move(*shader));
        } else if (well) {
            well = shader.error();
        }
    };
    add(compile({kSkyVertex}, {kAround, kSkyFragment}));
    add(compile({kShadowVertex}, {kBoxes, kShadowFragment}));
    add(compile({kShadedVertex}, {kAround, kShadedFragment}));
    add(compile({kSolidVertex}, {kAround, kInkFragment}));
    add(compile({kMarkVertex}, {kMarkFragment}));
    add(compile({kShadowVertex}, {kSmoothFragment}));
    auto floor = compile_floor(0);
    auto solid = compile_solid(0);
    for (const auto* shader : {&floor, &solid}) {
        if (!*shader && well) well = shader->error();
    }
    if (!well) return well.error();
    SpacePainter painter(std::move(shaders));
    painter.floors_[0].emplace(std::move(*floor));
    painter.solids_[0].emplace(std::move(*solid));
    return painter;
}

SpacePainter::SpacePainter(std::vector<Shader> shaders)
    : shaders_(std::move(shaders)), objects_(std::make_unique<SpaceBuffers>()) {
    shaders_[kShadow].use_block("Boxes", 0);
}

// The others are compiled when they are needed. If a driver refuses one, the plain one serves.
const Shader& SpacePainter::floor_shader(std::size_t features) {
    std::optional<Shader>& shader = floors_[features];
    if (!shader) {
        if (auto made = compile_floor(features)) shader.emplace(std::move(*made));
    }
    return shader ? *shader : *floors_[0];
}

const Shader& SpacePainter::solid_shader(std::size_t pattern) {
    std::optional<Shader>& shader = solids_[pattern];
    if (!shader) {
        if (auto made = compile_solid(pattern)) shader.emplace(std::move(*made));
    }
    const Shader& chosen = shader ? *shader : *solids_[0];
    chosen.use_block("Boxes", 0);
    return chosen;
}

SpacePainter::~SpacePainter() = default;
SpacePainter::SpacePainter(SpacePainter&& other) noexcept = default;

// Returns whether there is a picture of that size.
bool SpacePainter::make_room(int width, int height) {
    if (!shadow_) {
        auto made = PaintedTexture::create(kShadowSide, kShadowSide);
        if (!made) return false;
        shadow_.emplace(std::move(*made));
    }
    if (picture_ && picture_->width() >= width && picture_->height() >= height) return true;
    const int wide = std::max(width, picture_ ? picture_->width() : 0);
    const int high = std::max(height, picture_ ? picture_->height() : 0);
    picture_.reset();
    auto made = PaintedTexture::create(wide, high, PaintedTexture::Depth::kKept);
    if (!made) return false;
    picture_.emplace(std::move(*made));
    return true;
}

namespace {

void give_around(const Shader& shader, const SpaceFrame& frame, const Vec3& eye, const Vec3& sun) {
    give(shader, "eye", floats(eye));
    give(shader, "sun", floats(sun));
    give(shader, "level", frame.light.around[0]);
    give(shader, "upwards", frame.light.around[1]);
    give(shader, "downwards", frame.light.around[2]);
    glUniform2f(shader.uniform("haze"), static_cast<float>(frame.light.haze_from),
                static_cast<float>(frame.light.haze_depth));
}

}  // namespace

SpacePainter::Footprint SpacePainter::footprint_of(const SpaceFrame& frame) const {
    Footprint result;
    const Vec3 sun = frame.light.direction.normalized();
    for (const std::size_t index : boxes_.solids) {
        const Solid& solid = frame.solids[index];
        const double above = solid.pose.position.y() - frame.floor->height;
        const Vec3 foot = solid.pose.position - above / sun.y() * sun;
        const double soft = kPenumbra * std::max(0.0, above) / sun.y();
        const double reach = 1.6 * solid.half_extents.norm() + soft + 0.1;
        const Vec3 at = foot - frame.camera.target;
        result.add({at.x(), at.z()}, reach);
    }
    return result;
}

void SpacePainter::draw_shadow(const SpaceFrame& frame, const Seen& seen) {
    shadow_->bind_to_draw();
    const Shader& shader = shaders_[kShadow];
    shader.use();
    give(shader, "sun", floats(seen.sun));
    give(shader, "area",
         std::array{seen.foot.low.x(), seen.foot.low.y(), seen.foot.size().x(),
                    seen.foot.size().y()});
    give(shader, "height", frame.floor->height - frame.camera.target.y());
    give(shader, "soft", kPenumbra);
    give(shader, "count", static_cast<int>(boxes_.solids.size()));
    objects_->draw_cover();
}

void SpacePainter::draw_around(const SpaceFrame& frame, const Seen& seen, const Place& place) {
    const Shader& shader = shaders_[kSky];
    shader.use();
    give_around(shader, frame, seen.eye, seen.sun);
    const double half = 0.5 / seen.camera.pixels_per_metre;
    const Vec3 columns[3] = {half * seen.width * seen.camera.right,
                             half * seen.height * seen.camera.up,
                             -seen.camera.distance() * seen.camera.back};
    std::array<float, 9> look{};
    for (std::size_t k = 0; k < 3; ++k) {
        const Floats3 column = floats(columns[k]);
        std::copy(column.begin(), column.end(), look.begin() + 3 * k);
    }
    glUniformMatrix3fv(shader.uniform("look"), 1, GL_FALSE, look.data());
    // Above a floor, only what is over the horizon is seen.
    const int low = seen.rows_of_floor(frame.floor ? &*frame.floor : nullptr, frame.camera.target);
    const PixelRect& part = place.part;
    const int from = std::clamp(low, part.y, part.y + part.height);
    glScissor(place.x + part.x, place.y + from, part.width, part.y + part.height - from);
    objects_->draw_cover();
    place.use();
}

void SpacePainter::draw_floor(const SpaceFrame& frame, const Seen& seen) {
    const SpaceFloor& floor = *frame.floor;
    const std::size_t features = (floor.grain > 0.0F ? kGrainy : 0) |
                                 (floor.ripples > 0.0F ? kGrainy | kRippled : 0) |
                                 (floor.lines.a > 0.0F ? kLined : 0);
    const Shader& shader = floor_shader(features);
    shader.use();
    give_around(shader, frame, seen.eye, seen.sun);
    give(shader, "view", seen.view);
    glUniform2f(shader.uniform("middle"), static_cast<float>(seen.eye.x()),
                static_cast<float>(seen.eye.z()));
    const double height = floor.height - frame.camera.target.y();
    give(shader, "height", height);
    give(shader, "reach", kFloorReach * seen.camera.distance());
    give(shader, "base", floor.color);
    give(shader, "lines",
         std::array{static_cast<double>(floor.lines.r), static_cast<double>(floor.lines.g),
                    static_cast<double>(floor.lines.b), static_cast<double>(floor.lines.a)});
    // All that repeats on the floor does so after 100 m.
    const auto origin = [](double at) { return static_cast<float>(-std::fmod(at, 100.0)); };
    glUniform2f(shader.uniform("origin"), origin(frame.camera.target.x()),
                origin(frame.camera.target.z()));
    const double drift = std::fmod(0.021 * floor.time, 1.0);
    give(shader, "surface",
         std::array{static_cast<double>(floor.grain), static_cast<double>(floor.ripples), drift,
                    std::fmod(0.6 * drift, 1.0)});
    give(shader, "grain", 1);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, objects_->grain());
    glActiveTexture(GL_TEXTURE0);
    objects_->draw_strip();
    if (seen.foot.empty()) return;
    const Shader& shaded = shaders_[kShaded];
    shaded.use();
    give_around(shaded, frame, seen.eye, seen.sun);
    give(shaded, "view", seen.view);
    give(shaded, "height", height);
    give(shaded, "shade", static_cast<double>(floor.shade));
    give(shaded, "area",
         std::array{seen.foot.low.x(), seen.foot.low.y(), seen.foot.size().x(),
                    seen.foot.size().y()});
    give(shaded, "shadow", 0);
    shadow_->bind_to_sample();
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_SRC_ALPHA, GL_ZERO, GL_ONE);
    objects_->draw_strip();
    glDisable(GL_BLEND);
}

void SpacePainter::draw_scenery(const SpaceFrame& frame, const Seen& seen, const Place& place) {
    place.use();
    draw_around(frame, seen, place);
    if (frame.floor) draw_floor(frame, seen);
}

void SpacePainter::prepare(const Shader& shader, const SpaceFrame& frame, const Seen& seen,
                           double grow) const {
    shader.use();
    give_around(shader, frame, seen.eye, seen.sun);
    give(shader, "view", seen.view);
    const Vec3& back = seen.camera.back;
    give(shader, "grow", std::array{grow, back.x(), back.y(), back.z()});
    give(shader, "key", frame.light.key);
    give(shader, "above", frame.light.above);
    give(shader, "below", frame.light.below);
    give(shader, "dimness", frame.light.dimness);
    give(shader, "ink", static_cast<double>(frame.ink));
}

// Draws solids in their order, together those that follow one another with the same pattern.
void SpacePainter::draw_runs(std::span<const SolidInstance> instances, const SpaceFrame& frame,
                             const Seen& seen) {
    while (!instances.empty()) {
        const float pattern = instances.front().look[0];
        const auto end =
            std::find_if(instances.begin(), instances.end(),
                         [pattern](const SolidInstance& each) { return each.look[0] != pattern; });
        const auto count = static_cast<std::size_t>(end - instances.begin());
        prepare(solid_shader(static_cast<std::size_t>(pattern)), frame, seen, 0.0);
        objects_->fill(instances.first(count));
        objects_->draw_solids(count);
        instances = instances.subspan(count);
    }
}

// Nearer solids are drawn before those that they hide.
void SpacePainter::draw_opaque(const SpaceFrame& frame, const Seen& seen) {
    for (const bool inked : {false, true}) {
        const std::vector<SolidInstance> instances =
            instances_of(frame, boxes_, SolidsWanted::kOpaque, inked);
        draw_runs(instances, frame, seen);
        if (!inked || instances.empty() || frame.outline <= 0.0) continue;
        prepare(shaders_[kInk], frame, seen, frame.outline * frame.samples * seen.pixel());
        glCullFace(GL_FRONT);
        objects_->fill(instances);
        objects_->draw_solids(instances.size());
        glCullFace(GL_BACK);
    }
}

// Draws the solids and marks, and the scenery where they do not hide it.
void SpacePainter::draw_busy(const SpaceFrame& frame, const Seen& seen, const Place& place) {
    place.use();
    const Color& ground = frame.light.around[2];
    glClearColor(ground.r * frame.ink, ground.g * frame.ink, ground.b * frame.ink, 0.0F);
    glClear(frame.clear ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    draw_opaque(frame, seen);
    glDisable(GL_CULL_FACE);
    if (!frame.clear) {
        glDepthMask(GL_FALSE);
        glDepthRange(1.0, 1.0);  // behind all solids
        draw_scenery(frame, seen, place);
        glDepthRange(0.0, 1.0);
        glDepthMask(GL_TRUE);
    }
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_CULL_FACE);
    for (const bool inked : {false, true})
        draw_runs(instances_of(frame, boxes_, SolidsWanted::kSeeThrough, inked), frame, seen);
    glDisable(GL_CULL_FACE);
    draw_marks(frame, seen);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
}

void SpacePainter::draw_marks(const SpaceFrame& frame, const Seen& seen) {
    if (frame.marks.empty()) return;
    std::vector<MarkInstance> marks;
    for (const SpaceMark& mark : frame.marks) {
        const Floats3 at = floats(mark.place - frame.camera.target);
        marks.push_back(
            {{at[0], at[1], at[2], static_cast<float>(mark.radius)},
             {mark.color.r, mark.color.g, mark.color.b, mark.color.a},
             {static_cast<float>(mark.least * frame.samples * seen.pixel()), mark.softness}});
    }
    const Shader& shader = shaders_[kMark];
    shader.use();
    give(shader, "view", seen.view);
    give(shader, "right", floats(seen.camera.right));
    give(shader, "up", floats(seen.camera.up));
    give(shader, "back", floats(seen.camera.back));
    give(shader, "eye", floats(seen.eye));
    glDepthMask(GL_FALSE);
    objects_->draw_marks(marks);
    glDepthMask(GL_TRUE);
}

namespace {

// Returns the pixels of a picture, from its lower left corner, in which its solids are.
PixelRect pixels_of_solids(const SpaceFrame& frame, const PixelRect& target) {
    Vec2 low = Vec2::Constant(1e9);
    Vec2 high = Vec2::Constant(-1e9);
    for (const Solid& solid : frame.solids) {
        const SpaceCamera::Seen middle = frame.camera.look_at(solid.pose.position);
        const double reach = solid.half_extents.norm() * frame.camera.pixels_per_metre *
                                 frame.camera.distance() / std::max(middle.distance, 0.05) +
                             4.0;
        low = low.cwiseMin(middle.place - Vec2::Constant(reach));
        high = high.cwiseMax(middle.place + Vec2::Constant(reach));
    }
    const auto whole = [](double pixels, int most) {
        return static_cast<int>(std::clamp(pixels, 0.0, static_cast<double>(most)));
    };
    const int left = whole(std::floor(low.x()), target.width);
    const int right = whole(std::ceil(high.x()), target.width);
    const int foot = whole(std::floor(target.height - high.y()), target.height);
    const int top = whole(std::ceil(target.height - low.y()), target.height);
    return {left, foot, std::max(0, right - left), std::max(0, top - foot)};
}

// Returns what a rectangle leaves of a picture around it.
std::array<PixelRect, 4> around_it(const PixelRect& hole, int width, int height) {
    const int right = hole.x + hole.width;
    const int top = hole.y + hole.height;
    return {PixelRect{0, 0, width, hole.y}, PixelRect{0, top, width, height - top},
            PixelRect{0, hole.y, hole.x, hole.height},
            PixelRect{right, hole.y, width - right, hole.height}};
}

}  // namespace

// Copies part of the picture, with smooth edges.
void SpacePainter::copy_out(const SpaceFrame& frame, const Seen& seen, const Place& place) {
    const PixelRect& part = place.part;
    if (frame.samples > 1 || frame.clear) {
        picture_->bind_to_copy();
        const int width = part.width / frame.samples;
        const int height = part.height / frame.samples;
        glBlitFramebuffer(0, 0, seen.width, seen.height, place.x, place.y, place.x + width,
                          place.y + height, GL_COLOR_BUFFER_BIT,
                          frame.samples > 1 ? GL_LINEAR : GL_NEAREST);
    }
    if (frame.samples > 1) return;
    glViewport(place.x + part.x, place.y + part.y, part.width, part.height);
    const Shader& shader = shaders_[kSmooth];
    shader.use();
    glUniform2f(shader.uniform("pixel"), 1.0F / static_cast<float>(picture_->width()),
                1.0F / static_cast<float>(picture_->height()));
    glUniform2i(shader.uniform("corner"), place.x, place.y);
    give(shader, "picture", 0);
    picture_->bind_to_sample();
    objects_->draw_cover();
}

// The solids are drawn into a picture of their own, all else straight into the target.
void SpacePainter::draw(const SpaceFrame& frame, const PixelRect& target) {
    if (target.width < 1 || target.height < 1) return;
    Seen seen(frame, target);
    GLint before = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
    if (!make_room(seen.width, seen.height)) {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
        return fill_rect(target, frame.light.around[0]);
    }
    list_boxes(frame, boxes_);
    objects_->use_boxes(boxes_.numbers);
    if (frame.floor && !frame.clear) seen.foot = footprint_of(frame);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    if (!seen.foot.empty()) draw_shadow(frame, seen);
    const bool all = frame.samples > 1 || frame.clear;
    const PixelRect busy =
        all ? PixelRect{0, 0, seen.width, seen.height} : pixels_of_solids(frame, target);
    glEnable(GL_SCISSOR_TEST);
    if (busy.width > 0 && busy.height > 0) {
        picture_->bind_to_draw();
        glViewport(0, 0, seen.width, seen.height);
        // Smoothing looks at the pixels beside each.
        draw_busy(frame, seen, {0, 0, {busy.x - 2, busy.y - 2, busy.width + 4, busy.height + 4}});
    }
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
    glViewport(target.x, target.y, target.width, target.height);
    for (const PixelRect& part : around_it(busy, seen.width, seen.height)) {
        if (part.width <= 0 || part.height <= 0) continue;
        draw_scenery(frame, seen, {target.x, target.y, part});
        glEnable(GL_BLEND);
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        draw_marks(frame, seen);
        glDisable(GL_BLEND);
    }
    glScissor(target.x, target.y, target.width, target.height);
    if (busy.width > 0 && busy.height > 0) copy_out(frame, seen, {target.x, target.y, busy});
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(before));
}

}  // namespace cambrian
