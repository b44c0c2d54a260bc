#include "render/backdrop_painter.h"

#include "render/backdrop_shaders.h"
#include "render/filled_rect.h"
#include "render/opengl/gl.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostSceneries = 3;
constexpr int kWidthStep = 256;  // px; views of nearly the same size share a scenery
constexpr int kHeightStep = 128;
constexpr int kLeastWidth = 1024;   // px, of a far picture, so that it does not repeat soon
constexpr double kFarSpeed = 0.10;  // of far hills, as a share of the ground's
constexpr int kTileWidth = 1024;    // texels of a tile of ground
constexpr int kTileHeight = 512;
constexpr int kParts = 4;  // of each of sky, finished sky and tile
constexpr int kRidges = 3;
constexpr int kPaintingSteps = 3 * kParts + kRidges;  // in which a scenery is painted
constexpr double kTileMetres = 4.0;  // width of a tile, or this times a power of two

int rounded_up(int value, int step) {
    return (value + step - 1) / step * step;
}

int horizon_of(int height) {
    return height * 26 / 100;
}

// Returns the width in metres of a tile whose texels are nearest to a pixel.
double tile_metres(double pixels_per_metre) {
    double metres = kTileMetres;
    while (metres * pixels_per_metre > 1.45 * kTileWidth)
        metres *= 0.5;
    while (metres * pixels_per_metre < 0.7 * kTileWidth)
        metres *= 2.0;
    return metres;
}

Color deep_soil(const BackdropRecipe& recipe) {
    return mix(recipe.ground[2], color_of(0x000000), 0.08F);
}

// Returns the remainder in 0 .. period - 1.
int wrapped(double value, int period) {
    const double rest = std::fmod(std::floor(value), period);
    return static_cast<int>(rest < 0.0 ? rest + period : rest);
}

// Returns the height in pixels of a height in metres above the lower edge of the view.
int surface_of(const Camera& camera, const PixelRect& target, double height = 0.0) {
    const double most = 4.0 * target.height;
    const double at = 0.5 * target.height + (height - camera.center.y()) * camera.pixels_per_metre;
    return static_cast<int>(std::round(std::clamp(at, -most, most)));
}

void give_color(const Shader& shader, const char* name, const Color& color) {
    glUniform3f(shader.uniform(name), color.r, color.g, color.b);
}

void give_size(const Shader& shader, const PaintedTexture& texture) {
    shader.use();
    glUniform2f(shader.uniform("size"), static_cast<float>(texture.width()),
                static_cast<float>(texture.height()));
}

void give(const Shader& shader, const char* name, double a, double b, double c) {
    glUniform3f(shader.uniform(name), static_cast<float>(a), static_cast<float>(b),
                static_cast<float>(c));
}

// Copies a rectangle of the bound source; x and y are where it comes from.
void copy(int x, int y, const PixelRect& to) {
    if (to.width <= 0 || to.height <= 0) return;
    glBlitFramebuffer(x, y, x + to.width, y + to.height, to.x, to.y, to.x + to.width,
                      to.y + to.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

// Copies a source that repeats after `period` pixels to a strip, from `from` on.
void copy_repeated(int from, int period, int y, const PixelRect& strip) {
    for (int done = 0; done < strip.width;) {
        const int count = std::min(strip.width - done, period - from);
        copy(from, y, {strip.x + done, strip.y, count, strip.height});
        done += count;
        from = 0;
    }
}

// The bound framebuffers, bound again at the end.
class KeptFramebuffers {
public:
    KeptFramebuffers() {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    }
    ~KeptFramebuffers() {
        bind_to_draw();
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    }
    KeptFramebuffers(const KeptFramebuffers&) = delete;
    KeptFramebuffers& operator=(const KeptFramebuffers&) = delete;
    void bind_to_draw() const {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
    }

private:
    GLint draw_ = 0;
    GLint read_ = 0;
};

Result<Shader> compile(const char* source) {
    const std::string whole = std::string(backdrop::kNoiseSource) + source;
    return Shader::compile(backdrop::kVertexSource, whole.c_str());
}

// Returns one of the parts that a texture is painted in.
PixelRect part_of(const PaintedTexture& texture, int part) {
    const int low = texture.height() * part / kParts;
    const int high = texture.height() * (part + 1) / kParts;
    return {0, low, texture.width(), high - low};
}

// Fills the target with the colours of sky and ground. `surface` is the height of the ground.
void fill_plainly(const BackdropRecipe& recipe, const PixelRect& target, int surface) {
    constexpr int kStripes = 48;
    const int horizon = recipe.has_ground ? std::clamp(surface, 0, target.height) : 0;
    const int above = target.height - horizon;
    for (int i = 0; i < kStripes; ++i) {
        const float share = 2.0F * static_cast<float>(i) / kStripes;
        const Color color = share < 1.0F ? mix(recipe.sky[0], recipe.sky[1], share)
                                         : mix(recipe.sky[1], recipe.sky[2], share - 1.0F);
        const int low = horizon + above * i / kStripes;
        const int high = horizon + above * (i + 1) / kStripes;
        fill_rect({target.x, target.y + low, target.width, high - low}, color);
    }
    fill_rect({target.x, target.y, target.width, horizon}, recipe.ground[1]);
}

// Fills what is seen above low ground and below the horizon: far land, and soil in the shade where
// it is deeper.
void fill_behind_ground(const BackdropRecipe& recipe, const PixelRect& target, int horizon,
                        double pixels_per_metre) {
    constexpr int kStripes = 24;
    constexpr double kShade = 1.0;  // m below the horizon, from where all is shade
    const Color land = recipe.ridges.back()[1];
    const Color shade = mix(recipe.ground[1], recipe.ground[2], 0.75F);
    const double depth = kShade * pixels_per_metre;
    int high = std::clamp(horizon, 0, target.height);
    for (int i = 1; i <= kStripes && high > 0; ++i) {
        const double below = i < kStripes ? horizon - depth * i / kStripes : 0.0;
        const int low = std::clamp(static_cast<int>(below), 0, high);
        const float share = static_cast<float>(i - 1) / (kStripes - 1);
        fill_rect({target.x, target.y + low, target.width, high - low},
                  mix(land, shade, share * share * (3.0F - 2.0F * share)));
        high = low;
    }
}

// How rough a chain is, by its form and nearness.
double roughness(RidgeForm form, std::size_t chain) {
    switch (form) {
        case RidgeForm::kSeabed:
            return 0.10;
        case RidgeForm::kBergs:
            return 0.03;
        default:
            return 0.025 + 0.012 * static_cast<double>(chain);
    }
}

}  // namespace

Result<BackdropPainter> BackdropPainter::create() {
    std::vector<Shader> shaders;
    for (const char* source :
         {backdrop::kSkySource, backdrop::kFinishSource, backdrop::kRidgeSource,
          backdrop::kSoilSource, backdrop::kScaleSource, backdrop::kSlopeSource}) {
        Result<Shader> shader = compile(source);
        if (!shader) return shader.error();
        shaders.push_back(std::move(*shader));
    }
    return BackdropPainter(std::move(shaders));
}

BackdropPainter::BackdropPainter(std::vector<Shader> shaders) : shaders_(std::move(shaders)) {}

void BackdropPainter::cover(const PixelRect& part) {
    const auto left = static_cast<float>(part.x);
    const auto low = static_cast<float>(part.y);
    const auto right = static_cast<float>(part.x + part.width);
    const auto high = static_cast<float>(part.y + part.height);
    const std::array<float, RectangleBuffer::kFloats> corners = {
        left, low, right, low, left, high, left, high, right, low, right, high};
    rectangle_.fill(corners);
    rectangle_.draw(0, 1);
}

BackdropPainter::Scenery& BackdropPainter::scenery_for(const BackdropRecipe& recipe,
                                                       const PixelRect& target) {
    const int width = std::max(kLeastWidth, rounded_up(target.width, kWidthStep));
    const int height = rounded_up(target.height, kHeightStep);
    const auto found = std::find_if(sceneries_.begin(), sceneries_.end(), [&](const Scenery& each) {
        return each.recipe == &recipe && each.width == width && each.height == height;
    });
    if (found != sceneries_.end()) {
        std::rotate(found, found + 1, sceneries_.end());
        return sceneries_.back();
    }
    if (sceneries_.size() == kMostSceneries) sceneries_.erase(sceneries_.begin());
    Scenery& scenery = sceneries_.emplace_back();
    scenery.recipe = &recipe;
    scenery.width = width;
    scenery.height = height;
    return scenery;
}

void BackdropPainter::bake(Scenery& scenery, Baking baking) {
    const int last =
        baking == Baking::kAtOnce ? kPaintingSteps : std::min(kPaintingSteps, scenery.steps + 1);
    if (scenery.steps >= last) return;
    const KeptFramebuffers kept;
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    for (; scenery.steps < last; ++scenery.steps)
        paint_step(scenery);
    glEnable(GL_BLEND);
    glEnable(GL_SCISSOR_TEST);
}

void BackdropPainter::paint_step(Scenery& scenery) {
    int step = scenery.steps;
    if (step < kParts) return paint_sky(scenery, step);
    step -= kParts;
    if (step < kParts) return finish_sky(scenery, step);
    step -= kParts;
    if (step < kRidges) return paint_ridge(scenery, static_cast<std::size_t>(step));
    if (scenery.recipe->has_ground) paint_tile(scenery, step - kRidges);
}

void BackdropPainter::paint_sky(Scenery& scenery, int part) {
    const BackdropRecipe& recipe = *scenery.recipe;
    // What stands on the ground may be seen from above, so there is more sky than in one view.
    const int above = recipe.has_ground ? scenery.height / 4 : 0;
    if (part == 0) {
        Result<PaintedTexture> half =
            PaintedTexture::create(scenery.width / 2, (scenery.height + above) / 2);
        Result<PaintedTexture> far = PaintedTexture::create(scenery.width, scenery.height + above);
        if (!half || !far) return;
        scenery.half = std::move(*half);
        scenery.far = std::move(*far);
    }
    if (!scenery.half) return;
    scenery.half->bind_to_draw();
    const Shader& sky = shaders_[kSky];
    give_size(sky, *scenery.half);
    give_color(sky, "low", recipe.sky[0]);
    give_color(sky, "middle", recipe.sky[1]);
    give_color(sky, "high", recipe.sky[2]);
    const double begin = recipe.has_ground ? 0.5 * horizon_of(scenery.height) : 0.0;
    give(sky, "ranges", 0.5 * begin, 0.5 * (scenery.height - begin), 0.5 * scenery.height);
    glUniform2f(sky.uniform("weather"), recipe.clouds, recipe.shafts);
    cover(part_of(*scenery.half, part));
}

void BackdropPainter::finish_sky(Scenery& scenery, int part) {
    if (!scenery.far) return;
    const BackdropRecipe& recipe = *scenery.recipe;
    scenery.far->bind_to_draw();
    scenery.half->bind_to_sample();
    const Shader& finish = shaders_[kFinish];
    give_size(finish, *scenery.far);
    const bool among_stars =
        recipe.body == HeavenlyBody::kEarth || recipe.body == HeavenlyBody::kCrescent;
    give(finish, "body", recipe.body_place.x() * scenery.width,
         recipe.body_place.y() * scenery.height,
         among_stars ? recipe.body_radius * scenery.height : 0.0);
    glUniform4f(finish.uniform("body_color"), recipe.body_color.r, recipe.body_color.g,
                recipe.body_color.b, recipe.body == HeavenlyBody::kEarth ? 1.0F : 0.0F);
    glUniform1f(finish.uniform("stars"), recipe.stars);
    glUniform2f(finish.uniform("ranges"), 0.25F * static_cast<float>(scenery.height),
                0.65F * static_cast<float>(scenery.height));
    cover(part_of(*scenery.far, part));
    if (part == kParts - 1) scenery.half.reset();
}

void BackdropPainter::paint_ridge(const Scenery& scenery, std::size_t i) {
    if (!scenery.far) return;
    const BackdropRecipe& recipe = *scenery.recipe;
    const auto& [crest, foot] = recipe.ridges[i];
    const int chain = static_cast<int>(i);
    scenery.far->bind_to_draw();
    const Shader& ridge = shaders_[kRidge];
    give_size(ridge, *scenery.far);
    glUniform1i(ridge.uniform("form"), static_cast<int>(recipe.form));
    // With ground, all stand on the horizon; else nearer ones lie deeper.
    const int high = scenery.height * (recipe.has_ground ? 24 - 3 * chain : 30) / 100;
    const int low =
        recipe.has_ground ? horizon_of(scenery.height) - 2 : high * (15 * (2 - chain) - 25) / 100;
    const int waves = (4 + 2 * chain) * scenery.width / kLeastWidth;
    glUniform4f(ridge.uniform("strip"), static_cast<float>(low), static_cast<float>(high),
                static_cast<float>(3 + 7 * chain), static_cast<float>(waves));
    give_color(ridge, "crest", crest);
    give_color(ridge, "foot", foot);
    const float shine = recipe.form == RidgeForm::kSeabed ? 0.03F : 0.12F;
    const Color glint = mix(crest, color_of(0xFFFFFF), 0.5F);
    give(ridge, "glint", static_cast<double>(shine * glint.r), static_cast<double>(shine * glint.g),
         static_cast<double>(shine * glint.b));
    glUniform1f(ridge.uniform("rough"), static_cast<float>(roughness(recipe.form, i)));
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    cover({0, low, scenery.far->width(), high});
    glDisable(GL_BLEND);
}

void BackdropPainter::paint_tile(Scenery& scenery, int part) {
    if (part == 0) {
        if (Result<PaintedTexture> tile = PaintedTexture::create(kTileWidth, kTileHeight))
            scenery.tile = std::move(*tile);
    }
    if (!scenery.tile) return;
    scenery.tile->bind_to_draw();
    const Shader& soil = shaders_[kSoil];
    give_size(soil, *scenery.tile);
    const BackdropRecipe& recipe = *scenery.recipe;
    give_color(soil, "cover", recipe.ground[0]);
    give_color(soil, "upper", recipe.ground[1]);
    give_color(soil, "deep", recipe.ground[2]);
    give_color(soil, "stones", recipe.ground[3]);
    glUniform1i(soil.uniform("form"), static_cast<int>(recipe.soil));
    cover(part_of(*scenery.tile, part));
}

void BackdropPainter::scale_ground(Scenery& scenery, double pixels_per_metre) {
    const KeptFramebuffers kept;  // creating a texture binds it
    scenery.scale = pixels_per_metre;
    const int width =
        static_cast<int>(std::round(tile_metres(pixels_per_metre) * pixels_per_metre));
    Result<PaintedTexture> ground = PaintedTexture::create(width, kTileHeight * width / kTileWidth);
    if (!ground) {
        scenery.ground.reset();
        return;
    }
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    ground->bind_to_draw();
    scenery.tile->bind_to_sample();
    const Shader& scale = shaders_[kScale];
    give_size(scale, *ground);
    cover({0, 0, ground->width(), ground->height()});
    glEnable(GL_BLEND);
    glEnable(GL_SCISSOR_TEST);
    scenery.ground = std::move(*ground);
}

void BackdropPainter::draw(const BackdropRecipe& recipe, const GroundShape& shape,
                           const Camera& camera, const PixelRect& target, Baking baking) {
    glEnable(GL_SCISSOR_TEST);
    Scenery& scenery = scenery_for(recipe, target);
    bake(scenery, baking);
    const bool unfinished = scenery.steps < kPaintingSteps;
    unfinished_ = unfinished_ || unfinished;
    const int surface = recipe.has_ground ? surface_of(camera, target, shape.level) : 0;
    const bool ground_seen = !unfinished && scenery.tile && (surface > 0 || !shape.is_flat());
    if (ground_seen && scenery.scale != camera.pixels_per_metre)
        scale_ground(scenery, camera.pixels_per_metre);
    const KeptFramebuffers kept;
    glScissor(target.x, target.y, target.width, target.height);
    if (unfinished && scenery.far) {
        // Drivers compile their copying when it is first used; the pixel is covered below.
        scenery.far->bind_to_copy();
        copy(0, 0, {target.x, target.y, 1, 1});
    }
    if (unfinished || !scenery.far || (ground_seen && !scenery.ground))
        fill_plainly(recipe, target, surface);
    glScissor(target.x, target.y, target.width, target.height);
    if (!unfinished && scenery.far) copy_far(scenery, camera, target, surface);
    if (ground_seen && scenery.ground) {
        if (shape.is_flat())
            copy_ground(scenery, camera, target, {0, target.width, surface});
        else
            draw_shaped_ground(scenery, shape, camera, target);
    }
    glViewport(target.x, target.y, target.width, target.height);
}

void BackdropPainter::copy_far(const Scenery& scenery, const Camera& camera,
                               const PixelRect& target, int surface) const {
    scenery.far->bind_to_copy();
    const int width = scenery.far->width();
    const int height = scenery.far->height();
    const int from = wrapped(camera.center.x() * camera.pixels_per_metre * kFarSpeed, width);
    // Where the picture's lower edge is: the horizon lies on the ground, or the upper edges agree.
    const int low =
        scenery.recipe->has_ground ? surface - horizon_of(scenery.height) : target.height - height;
    const int first = std::clamp(low, 0, target.height);
    const int last = std::clamp(low + height, 0, target.height);
    copy_repeated(from, width, first - low,
                  {target.x, target.y + first, target.width, last - first});
    fill_rect({target.x, target.y + last, target.width, target.height - last},
              scenery.recipe->sky[2]);
    glScissor(target.x, target.y, target.width, target.height);
}

void BackdropPainter::copy_ground(const Scenery& scenery, const Camera& camera,
                                  const PixelRect& target, const GroundStrip& strip) const {
    scenery.ground->bind_to_copy();
    const double left = camera.center.x() * camera.pixels_per_metre - 0.5 * target.width;
    const int from = wrapped(left + strip.left, scenery.ground->width());
    const int high = std::clamp(strip.surface, 0, target.height);
    const int low = strip.surface - scenery.ground->height();
    const int first = std::clamp(low, 0, high);
    const int x = target.x + strip.left;
    copy_repeated(from, scenery.ground->width(), first - low,
                  {x, target.y + first, strip.width, high - first});
    fill_rect({x, target.y, strip.width, first}, deep_soil(*scenery.recipe));
    glScissor(target.x, target.y, target.width, target.height);
}

// Copies level pieces of the ground and draws the others, whose soil follows the surface.
void BackdropPainter::draw_shaped_ground(const Scenery& scenery, const GroundShape& shape,
                                         const Camera& camera, const PixelRect& target) {
    const double scale = camera.pixels_per_metre;
    const Vec2 origin =
        scale * camera.center - 0.5 * Vec2(target.width, target.height);  // of the view, in pixels
    fill_behind_ground(*scenery.recipe, target, surface_of(camera, target, shape.level), scale);
    glViewport(target.x, target.y, target.width, target.height);
    const Shader& slope = shaders_[kSlope];
    slope.use();
    glUniform2f(slope.uniform("size"), static_cast<float>(target.width),
                static_cast<float>(target.height));
    glUniform2f(slope.uniform("view"), static_cast<float>(target.x), static_cast<float>(target.y));
    give(slope, "tile", scenery.ground->width(), scenery.ground->height(),
         wrapped(origin.x(), scenery.ground->width()));
    give_color(slope, "deep", deep_soil(*scenery.recipe));
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    for (std::size_t i = 1; i < shape.surface.size(); ++i) {
        const Vec2 from = scale * shape.surface[i - 1] - origin;
        const Vec2 to = scale * shape.surface[i] - origin;
        const int left =
            static_cast<int>(std::clamp(std::round(from.x()), 0.0, 1.0 * target.width));
        const int right = static_cast<int>(std::clamp(std::round(to.x()), 0.0, 1.0 * target.width));
        if (right <= left) continue;
        glScissor(target.x, target.y, target.width, target.height);
        if (std::fabs(to.y() - from.y()) < 0.5) {
            const double most = 4.0 * target.height;
            const double height = std::clamp(std::round(from.y()), -most, most);
            copy_ground(scenery, camera, target, {left, right - left, static_cast<int>(height)});
            continue;
        }
        const double steepness = (to.y() - from.y()) / (to.x() - from.x());
        slope.use();
        scenery.ground->bind_to_sample();
        give(slope, "line", from.x(), from.y(), steepness);
        const auto edge = [&](int x) {
            const double height = from.y() + steepness * (x - from.x()) + 1.0;
            return static_cast<float>(std::clamp(height, 0.0, target.height + 1.0));
        };
        const auto a = static_cast<float>(left);
        const auto b = static_cast<float>(right);
        const float high_a = std::max(edge(left), edge(right));
        const std::array<float, RectangleBuffer::kFloats> corners = {a, 0.0F,   b, 0.0F, a, high_a,
                                                                     a, high_a, b, 0.0F, b, high_a};
        rectangle_.fill(corners);
        rectangle_.draw(0, 1);
    }
}

}  // namespace cambrian
