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

using Floats3 = std::array<float, 3>;
using Matrix = std::array<float, 16>;  // column by column

constexpr int kShadowSide = 96;    // texels
constexpr int kGrainSide = 256;    // texels
constexpr int kEdgeSteps = 2;      // of a quarter of a round edge, halved
constexpr double kNearest = 0.04;  // of the target's distance
constexpr double kFarPlane = 400.0;
constexpr double kFloorReach = 120.0;  // distances of the target
constexpr double kPenumbra = 0.30;     // width of a shadow's edge, in metres a metre of its height
constexpr std::size_t kBeside = 8;     // boxes that may shade a solid
constexpr std::size_t kBoxFloats = 16;

enum : std::size_t { kSky, kFloor, kShadow, kSolid, kInk, kMark, kSmooth };  // places of shaders

Floats3 floats(const Vec3& from) {
    return {static_cast<float>(from.x()), static_cast<float>(from.y()),
            static_cast<float>(from.z())};
}

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

const void* place_in_buffer(std::size_t offset) {
    return reinterpret_cast<const void*>(offset);  // NOLINT(performance-no-int-to-ptr)
}

void describe(GLuint location, GLint count, std::size_t stride, std::size_t offset,
              GLuint divisor) {
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, count, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          place_in_buffer(offset));
    glVertexAttribDivisor(location, divisor);
}

template <class Item>
void fill_buffer(GLuint buffer, std::span<const Item> items, GLenum use) {
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(items.size_bytes()), items.data(), use);
}

// Returns a number in [0, 1) that belongs to a point of a lattice.
float lattice(std::uint32_t x, std::uint32_t y, std::uint32_t salt) {
    std::uint32_t bits = x * 0x9E3779B1U ^ y * 0x85EBCA77U ^ salt * 0xC2B2AE3DU;
    bits = (bits ^ (bits >> 15U)) * 0x2C1B3C6DU;
    bits = (bits ^ (bits >> 12U)) * 0x297A2D39U;
    bits ^= bits >> 15U;
    return static_cast<float>(bits >> 8U) / 16777216.0F;
}

// Returns smooth noise, 0 to 1, that repeats after `period` cells each way.
float noise(float x, float y, std::uint32_t period, std::uint32_t salt) {
    const auto column = static_cast<std::uint32_t>(x);
    const auto row = static_cast<std::uint32_t>(y);
    const auto ease = [](float t) { return t * t * (3.0F - 2.0F * t); };
    const float right = ease(x - static_cast<float>(column));
    const float upper = ease(y - static_cast<float>(row));
    const auto at = [&](std::uint32_t i, std::uint32_t j) {
        return lattice((column + i) % period, (row + j) % period, salt);
    };
    const float low = at(0, 0) + right * (at(1, 0) - at(0, 0));
    const float high = at(0, 1) + right * (at(1, 1) - at(0, 1));
    return low + upper * (high - low);
}

// Returns how near a point is to the middle of the wall between two cells around scattered points,
// 0 to 1: the net of light that waves cast.
float net(float x, float y, std::uint32_t period) {
    const auto column = static_cast<int>(x);
    const auto row = static_cast<int>(y);
    float nearest = 9.0F;
    float second = 9.0F;
    const auto cells = static_cast<int>(period);
    for (int j = row - 1; j <= row + 1; ++j) {
        for (int i = column - 1; i <= column + 1; ++i) {
            const auto u = static_cast<std::uint32_t>((i + cells) % cells);
            const auto v = static_cast<std::uint32_t>((j + cells) % cells);
            const float dx = static_cast<float>(i) + lattice(u, v, 7) - x;
            const float dy = static_cast<float>(j) + lattice(u, v, 8) - y;
            const float away = std::sqrt(dx * dx + dy * dy);
            second = std::min(second, std::max(nearest, away));
            nearest = std::min(nearest, away);
        }
    }
    const float wall = std::clamp(1.0F - 2.2F * (second - nearest), 0.0F, 1.0F);
    return wall * wall;
}

// A texture that repeats: uneven colour in its red, a net of light in its green channel.
GLuint make_grain() {
    std::vector<std::uint8_t> texels;
    constexpr float kSide = kGrainSide;
    for (int y = 0; y < kGrainSide; ++y) {
        for (int x = 0; x < kGrainSide; ++x) {
            const float u = static_cast<float>(x) / kSide;
            const float v = static_cast<float>(y) / kSide;
            const float uneven = 0.5F * noise(8 * u, 8 * v, 8, 1) +
                                 0.3F * noise(24 * u, 24 * v, 24, 2) +
                                 0.2F * noise(72 * u, 72 * v, 72, 3);
            const float warp_x = 1.2F * noise(4 * u, 4 * v, 4, 4);
            const float warp_y = 1.2F * noise(4 * u, 4 * v, 4, 5);
            const float light =
                net(std::fmod(8 * u + warp_x, 8.0F), std::fmod(8 * v + warp_y, 8.0F), 8);
            for (const float share : {uneven, light, 0.0F, 1.0F})
                texels.push_back(static_cast<std::uint8_t>(255.0F * std::clamp(share, 0.0F, 1.0F)));
        }
    }
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kGrainSide, kGrainSide, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 texels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    return texture;
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

struct SpacePainter::Instance {
    std::array<float, 12> axes;  // of the solid, each with a number of its centre
    std::array<float, 4> size;
    std::array<float, 4> fill;
    std::array<float, 4> look;
    std::array<float, kBeside> beside;
};

struct SpacePainter::MarkInstance {
    std::array<float, 4> disc;
    std::array<float, 4> fill;
    std::array<float, 2> edge;
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

class SpacePainter::Objects {
public:
    Objects() : mesh_(rounded_box(kEdgeSteps)) {
        glGenVertexArrays(1, &empty_);
        glGenVertexArrays(1, &solids_);
        glGenVertexArrays(1, &marks_);
        glGenBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
        glBindVertexArray(solids_);
        fill_buffer<BoxVertex>(buffers_[0], mesh_.vertices, GL_STATIC_DRAW);
        describe(0, 3, sizeof(BoxVertex), offsetof(BoxVertex, corner), 0);
        describe(1, 3, sizeof(BoxVertex), offsetof(BoxVertex, normal), 0);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers_[1]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                     static_cast<GLsizeiptr>(mesh_.triangles.size() * sizeof(unsigned)),
                     mesh_.triangles.data(), GL_STATIC_DRAW);
        glBindBuffer(GL_ARRAY_BUFFER, buffers_[2]);
        for (GLuint i = 0; i < sizeof(Instance) / 16; ++i)
            describe(2 + i, 4, sizeof(Instance), std::size_t{16} * i, 1);
        glBindVertexArray(marks_);
        glBindBuffer(GL_ARRAY_BUFFER, buffers_[3]);
        describe(0, 4, sizeof(MarkInstance), offsetof(MarkInstance, disc), 1);
        describe(1, 4, sizeof(MarkInstance), offsetof(MarkInstance, fill), 1);
        describe(2, 2, sizeof(MarkInstance), offsetof(MarkInstance, edge), 1);
        glBindVertexArray(0);
        glBindBuffer(GL_UNIFORM_BUFFER, buffers_[4]);
        glBufferData(GL_UNIFORM_BUFFER, kMostShading * kBoxFloats * sizeof(float), nullptr,
                     GL_STREAM_DRAW);
        grain = make_grain();
    }
    ~Objects() {
        glDeleteTextures(1, &grain);
        glDeleteBuffers(static_cast<GLsizei>(buffers_.size()), buffers_.data());
        for (const GLuint array : {empty_, solids_, marks_})
            glDeleteVertexArrays(1, &array);
    }
    Objects(const Objects&) = delete;
    Objects& operator=(const Objects&) = delete;

    void use_boxes(std::span<const float> boxes) const {
        glBindBuffer(GL_UNIFORM_BUFFER, buffers_[4]);
        glBufferSubData(GL_UNIFORM_BUFFER, 0, static_cast<GLsizeiptr>(boxes.size_bytes()),
                        boxes.data());
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffers_[4]);
    }
    void fill(std::span<const Instance> instances) const {
        fill_buffer(buffers_[2], instances, GL_STREAM_DRAW);
    }
    void draw_solids(std::size_t count) const {
        glBindVertexArray(solids_);
        glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(mesh_.triangles.size()),
                                GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(count));
        glBindVertexArray(0);
    }
    void draw_marks(std::span<const MarkInstance> marks) const {
        fill_buffer(buffers_[3], marks, GL_STREAM_DRAW);
        glBindVertexArray(marks_);
        glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(marks.size()));
        glBindVertexArray(0);
    }
    // Runs the shader in use with no data; a strip has four corners, a cover three.
    void draw_strip() const { draw_plain(GL_TRIANGLE_STRIP, 4); }
    void draw_cover() const { draw_plain(GL_TRIANGLES, 3); }

    GLuint grain = 0;

private:
    void draw_plain(GLenum form, GLsizei corners) const {
        glBindVertexArray(empty_);
        glDrawArrays(form, 0, corners);
        glBindVertexArray(0);
    }

    BoxMesh mesh_;
    GLuint empty_ = 0;
    GLuint solids_ = 0;
    GLuint marks_ = 0;
    std::array<GLuint, 5> buffers_ = {};
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
    : shaders_(std::move(shaders)), objects_(std::make_unique<Objects>()) {
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

void SpacePainter::list_boxes(const SpaceFrame& frame) {
    shading_.clear();
    boxes_.clear();
    for (std::size_t i = 0; i < frame.solids.size() && shading_.size() < kMostShading; ++i) {
        const Solid& solid = frame.solids[i];
        if (!solid.shadows || solid.fill.a < 1.0F) continue;
        shading_.push_back(i);
        const auto turn = solid.pose.orientation.toRotationMatrix();
        const Floats3 at = floats(solid.pose.position - frame.camera.target);
        for (int axis = 0; axis < 3; ++axis) {
            for (const float number : floats(turn.col(axis)))
                boxes_.push_back(number);
            boxes_.push_back(at[static_cast<std::size_t>(axis)]);
        }
        for (const float number : floats(solid.half_extents))
            boxes_.push_back(number);
        boxes_.push_back(0.0F);
    }
}

std::vector<SpacePainter::Instance> SpacePainter::instances_of(const SpaceFrame& frame, bool opaque,
                                                               bool inked) const {
    std::vector<Instance> instances;
    const Vec3 sun = frame.light.direction.normalized();
    struct Neighbour {
        double away;
        std::size_t box;
    };
    std::vector<Neighbour> neighbours;
    for (std::size_t i = 0; i < frame.solids.size(); ++i) {
        const Solid& solid = frame.solids[i];
        if ((solid.fill.a >= 1.0F) != opaque || solid.inked != inked) continue;
        Instance instance{};
        const auto turn = solid.pose.orientation.toRotationMatrix();
        const Floats3 at = floats(solid.pose.position - frame.camera.target);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Floats3 column = floats(turn.col(static_cast<int>(axis)));
            std::copy(column.begin(), column.end(), instance.axes.begin() + 4 * axis);
            instance.axes[4 * axis + 3] = at[axis];
        }
        const Floats3 half = floats(solid.half_extents);
        instance.size = {half[0], half[1], half[2], static_cast<float>(solid.radius)};
        instance.fill = {solid.fill.r, solid.fill.g, solid.fill.b, solid.fill.a};
        instance.look = {static_cast<float>(solid.pattern), static_cast<float>(1.0 / solid.wave),
                         solid.phase, solid.gleams ? 1.0F : 0.0F};
        // The boxes that may lie between it and the sun, or beside it, the nearest first.
        neighbours.clear();
        const double own = solid.half_extents.norm();
        for (std::size_t box = 0; box < shading_.size(); ++box) {
            const Solid& other = frame.solids[shading_[box]];
            if (shading_[box] == i) continue;
            const Vec3 way = other.pose.position - solid.pose.position;
            const double along = way.dot(sun);
            const double aside = along > 0.0 ? (way - along * sun).norm() : way.norm();
            const double gap = aside - own - other.half_extents.norm();
            if (gap < 0.05) neighbours.push_back({gap, box});
        }
        std::stable_sort(neighbours.begin(), neighbours.end(),
                         [](const Neighbour& a, const Neighbour& b) { return a.away < b.away; });
        for (std::size_t k = 0; k < kBeside; ++k)
            instance.beside[k] =
                k < neighbours.size() ? static_cast<float>(neighbours[k].box) : -1.0F;
        instances.push_back(instance);
    }
    return instances;
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
    for (const std::size_t index : shading_) {
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
    give(shader, "count", static_cast<int>(shading_.size()));
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
    glBindTexture(GL_TEXTURE_2D, objects_->grain);
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
        const std::vector<Instance> instances = instances_of(frame, opaque, inked);
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
    list_boxes(frame);
    objects_->use_boxes(boxes_);
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
