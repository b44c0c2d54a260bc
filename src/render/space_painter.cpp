#include "render/space_painter.h"

#include "render/filled_rect.h"
#include "render/opengl/gl.h"
#include "render/space_shaders.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

namespace cambrian {
namespace {

using Matrix = std::array<float, 16>;  // column by column

constexpr int kShadowSide = 96;    // texels
constexpr double kNearest = 0.04;  // of the target's distance
constexpr double kFarPlane = 400.0;
constexpr double kFloorReach = 120.0;  // distances of the target
constexpr double kPenumbra = 0.30;     // width of a shadow's edge, in metres a metre of its height

enum : std::size_t { kSky, kFloor, kShadow, kSolid, kInk, kMark, kSmooth };  // places of shaders

void give(const Shader& shader, const char* name, const Floats3& value) {
    glUniform3f(shader.uniform(name), value[0], value[1], value[2]);
}
void give(const Shader& shader, const char* name, const Color& color) {
    glUniform3f(shader.uniform(name), color.r, color.g, color.b);
}
void give(const Shader& shader, const char* name, double value) {
    glUniform1f(shader.uniform(name), static_cast<float>(value));
}
void give(const Shader& shader, const char* name, int value) {
    glUniform1i(shader.uniform(name), value);
}
void give(const Shader& shader, const char* name, const std::array<double, 4>& four) {
    glUniform4f(shader.uniform(name), static_cast<float>(four[0]), static_cast<float>(four[1]),
                static_cast<float>(four[2]), static_cast<float>(four[3]));
}
void give(const Shader& shader, const char* name, const Matrix& matrix) {
    glUniformMatrix4fv(shader.uniform(name), 1, GL_FALSE, matrix.data());
}

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

}  // namespace

// The rectangle of the floor that shadows fall on.
struct SpacePainter::Footprint {
    Vec2 low = Vec2::Constant(1e9);
    Vec2 high = Vec2::Constant(-1e9);

    bool empty() const { return low.x() >= high.x(); }
    Vec2 size() const { return high - low; }
    void add(const Vec2& middle, double reach) {
        low = low.cwiseMin(middle - Vec2::Constant(reach));
        high = high.cwiseMax(middle + Vec2::Constant(reach));
    }
};

// The camera with places relative to its target.
struct SpacePainter::Seen {
    SpaceCamera camera;
    Vec3 eye;
    Vec3 sun;
    Matrix view;
    int width = 1;  // pixels
    int height = 1;
    Footprint foot = {};

    Seen(const SpaceFrame& frame, const PixelRect& target)
        : camera(frame.camera), sun(frame.light.direction.normalized()) {
        width = target.width * frame.samples;
        height = target.height * frame.samples;
        camera.width = width;
        camera.height = height;
        camera.pixels_per_metre *= frame.samples;
        eye = camera.distance() * camera.back;
        const double near = kNearest * camera.distance();
        const double far = kFarPlane * camera.distance();
        const double focal = 2.0 * camera.pixels_per_metre * camera.distance();
        const Vec3 x = focal / width * camera.right;
        const Vec3 y = focal / height * camera.up;
        const double steep = (far + near) / (far - near);
        for (int k = 0; k < 3; ++k) {
            const auto column = 4 * static_cast<std::size_t>(k);
            view[column] = static_cast<float>(x[k]);
            view[column + 1] = static_cast<float>(y[k]);
            view[column + 2] = static_cast<float>(-steep * camera.back[k]);
            view[column + 3] = static_cast<float>(-camera.back[k]);
        }
        view[12] = 0.0F;
        view[13] = 0.0F;
        view[14] = static_cast<float>(steep * camera.distance() - 2.0 * far * near / (far - near));
        view[15] = static_cast<float>(camera.distance());
    }
    double pixel() const { return 1.0 / (camera.pixels_per_metre * camera.distance()); }
};

Result<SpacePainter> SpacePainter::create() {
    using namespace space_shader;
    std::vector<Shader> shaders;
    const auto add = [&shaders](Result<Shader> shader) -> Status {
        if (!shader) return shader.error();
        shaders.push_back(std::move(*shader));
        return {};
    };
    for (const Status& status : {add(compile({kSkyVertex}, {kAround, kSkyFragment})),
                                 add(compile({kFloorVertex}, {kAround, kFloorFragment})),
                                 add(compile({kShadowVertex}, {kBoxes, kShadowFragment})),
                                 add(compile({kSolidVertex}, {kAround, kBoxes, kSolidFragment})),
                                 add(compile({kSolidVertex}, {kAround, kInkFragment})),
                                 add(compile({kMarkVertex}, {kMarkFragment})),
                                 add(compile({kShadowVertex}, {kSmoothFragment}))}) {
        if (!status) return status.error();
    }
    return SpacePainter(std::move(shaders));
}

SpacePainter::SpacePainter(std::vector<Shader> shaders)
    : shaders_(std::move(shaders)), objects_(std::make_unique<SpaceBuffers>()) {
    for (const std::size_t user : {kShadow, kSolid})
        shaders_[user].use_block("Boxes", 0);
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

void SpacePainter::draw_around(const SpaceFrame& frame, const Seen& seen) {
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
    const double rise = seen.camera.back.y();
    const double over_floor =
        frame.floor ? seen.eye.y() - frame.floor->height + frame.camera.target.y() : 0.0;
    if (over_floor > 0.0 && std::fabs(rise) < 0.9) {
        const double focal = seen.camera.pixels_per_metre * seen.camera.distance();
        const double level = std::sqrt(1.0 - rise * rise);
        const double horizon = 0.5 * seen.height + focal * rise / level;
        // The floor ends a little below it.
        const double gap = focal * over_floor / (kFloorReach * seen.camera.distance());
        const double most = seen.height;
        const int low =
            static_cast<int>(std::clamp(horizon - 4.0 - 2.0 * gap / (level * level), 0.0, most));
        glScissor(0, low, seen.width, seen.height - low);
    }
    objects_->draw_cover();
    glScissor(0, 0, seen.width, seen.height);
}

void SpacePainter::draw_floor(const SpaceFrame& frame, const Seen& seen) {
    const SpaceFloor& floor = *frame.floor;
    const Shader& shader = shaders_[kFloor];
    shader.use();
    give_around(shader, frame, seen.eye, seen.sun);
    give(shader, "view", seen.view);
    glUniform2f(shader.uniform("middle"), static_cast<float>(seen.eye.x()),
                static_cast<float>(seen.eye.z()));
    give(shader, "height", floor.height - frame.camera.target.y());
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
    const bool shaded = !seen.foot.empty();
    give(shader, "shade", shaded ? static_cast<double>(floor.shade) : 0.0);
    if (shaded)
        give(shader, "area",
             std::array{seen.foot.low.x(), seen.foot.low.y(), 1.0 / seen.foot.size().x(),
                        1.0 / seen.foot.size().y()});
    give(shader, "grain", 1);
    give(shader, "shadow", 0);
    glActiveTexture(GL_TEXTURE1);
    glBindTexture(GL_TEXTURE_2D, objects_->grain());
    shadow_->bind_to_sample();
    objects_->draw_strip();
}

void SpacePainter::draw_solids(const SpaceFrame& frame, const Seen& seen) {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CULL_FACE);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    const auto prepare = [&](const Shader& shader, double grow) {
        shader.use();
        give_around(shader, frame, seen.eye, seen.sun);
        give(shader, "view", seen.view);
        const Vec3& back = seen.camera.back;
        give(shader, "grow", std::array{grow, back.x(), back.y(), back.z()});
    };
    const Shader& solid = shaders_[kSolid];
    prepare(solid, 0.0);
    give(solid, "key", frame.light.key);
    give(solid, "above", frame.light.above);
    give(solid, "below", frame.light.below);
    give(solid, "dimness", frame.light.dimness);
    const auto draw = [&](bool opaque, bool inked) {
        const std::vector<SolidInstance> instances = instances_of(frame, boxes_, opaque, inked);
        if (instances.empty()) return std::size_t{0};
        objects_->fill(instances);
        objects_->draw_solids(instances.size());
        return instances.size();
    };
    draw(true, false);
    if (const std::size_t count = draw(true, true); count > 0 && frame.outline > 0.0) {
        prepare(shaders_[kInk], frame.outline * frame.samples * seen.pixel());
        give(shaders_[kInk], "ink", static_cast<double>(frame.ink));
        glCullFace(GL_FRONT);
        objects_->draw_solids(count);
        glCullFace(GL_BACK);
    }
    glEnable(GL_BLEND);
    solid.use();
    for (const bool inked : {false, true})
        draw(false, inked);
    glDisable(GL_CULL_FACE);
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

void SpacePainter::copy_out(const SpaceFrame& frame, const Seen& seen, const PixelRect& target) {
    picture_->bind_to_copy();
    if (frame.samples > 1) {
        glBlitFramebuffer(0, 0, seen.width, seen.height, target.x, target.y,
                          target.x + target.width, target.y + target.height, GL_COLOR_BUFFER_BIT,
                          GL_LINEAR);
        return;
    }
    glBlitFramebuffer(0, 0, seen.width, seen.height, target.x, target.y, target.x + target.width,
                      target.y + target.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    // The rectangle of the solids is copied once more, with smooth edges.
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
    if (left >= right || foot >= top) return;
    glViewport(target.x + left, target.y + foot, right - left, top - foot);
    const Shader& shader = shaders_[kSmooth];
    shader.use();
    const double across = 1.0 / picture_->width();
    const double along = 1.0 / picture_->height();
    glUniform2f(shader.uniform("pixel"), static_cast<float>(across), static_cast<float>(along));
    give(shader, "area",
         std::array{left * across, foot * along, (right - left) * across, (top - foot) * along});
    give(shader, "picture", 0);
    picture_->bind_to_sample();
    objects_->draw_cover();
}

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
    picture_->bind_to_draw();
    glViewport(0, 0, seen.width, seen.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, seen.width, seen.height);
    const Color& ground = frame.light.around[2];
    glClearColor(ground.r * frame.ink, ground.g * frame.ink, ground.b * frame.ink, 0.0F);
    glClear(frame.clear ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_DEPTH_BUFFER_BIT);
    if (!frame.clear) {
        draw_around(frame, seen);
        if (frame.floor) draw_floor(frame, seen);
    }
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    draw_solids(frame, seen);
    glEnable(GL_BLEND);
    draw_marks(frame, seen);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
    glScissor(target.x, target.y, target.width, target.height);
    copy_out(frame, seen, target);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(before));
}

}  // namespace cambrian
