#include "render/backdrop_painter.h"

#include "render/backdrop_shaders.h"
#include "render/filled_rect.h"
#include "render/opengl/kept_framebuffers.h"
#include "render/uniforms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostSceneries = 3;
constexpr int kWidthStep = 256;  // px; views of nearly the same size share a scenery
constexpr int kHeightStep = 128;
constexpr double kFarSpeed = 0.10;  // of far hills, as a share of the ground's

int rounded_up(int value, int step) {
    return (value + step - 1) / step * step;
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

}  // namespace

Result<BackdropPainter> BackdropPainter::create() {
    Result<BackdropPictures> pictures = BackdropPictures::create();
    if (!pictures) return pictures.error();
    Result<Shader> slope = backdrop_shader(backdrop::kSlopeSource);
    if (!slope) return slope.error();
    return BackdropPainter(std::move(*pictures), std::move(*slope));
}

PaintedBackdrop& BackdropPainter::scenery_for(const BackdropRecipe& recipe,
                                              const PixelRect& target) {
    const int width = std::max(PaintedBackdrop::kLeastWidth, rounded_up(target.width, kWidthStep));
    const int height = rounded_up(target.height, kHeightStep);
    const auto found =
        std::find_if(sceneries_.begin(), sceneries_.end(), [&](const PaintedBackdrop& each) {
            return each.recipe == &recipe && each.width == width && each.height == height;
        });
    if (found != sceneries_.end()) {
        std::rotate(found, found + 1, sceneries_.end());
        return sceneries_.back();
    }
    if (sceneries_.size() == kMostSceneries) sceneries_.erase(sceneries_.begin());
    PaintedBackdrop& scenery = sceneries_.emplace_back();
    scenery.recipe = &recipe;
    scenery.width = width;
    scenery.height = height;
    return scenery;
}

void BackdropPainter::draw(const BackdropRecipe& recipe, const GroundShape& shape,
                           const Camera& camera, const PixelRect& target, Baking baking) {
    glEnable(GL_SCISSOR_TEST);
    PaintedBackdrop& scenery = scenery_for(recipe, target);
    pictures_.bake(scenery, baking);
    const bool unfinished = !scenery.is_finished();
    unfinished_ = unfinished_ || unfinished;
    const int surface = recipe.has_ground ? surface_of(camera, target, shape.level) : 0;
    const bool ground_seen = !unfinished && scenery.tile && (surface > 0 || !shape.is_flat());
    if (ground_seen && scenery.scale != camera.pixels_per_metre)
        pictures_.scale_ground(scenery, camera.pixels_per_metre);
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

void BackdropPainter::copy_far(const PaintedBackdrop& scenery, const Camera& camera,
                               const PixelRect& target, int surface) const {
    scenery.far->bind_to_copy();
    const int width = scenery.far->width();
    const int height = scenery.far->height();
    const int from = wrapped(camera.center.x() * camera.pixels_per_metre * kFarSpeed, width);
    // Where the picture's lower edge is: the horizon lies on the ground, or the upper edges agree.
    const int low =
        scenery.recipe->has_ground ? surface - scenery.horizon() : target.height - height;
    const int first = std::clamp(low, 0, target.height);
    const int last = std::clamp(low + height, 0, target.height);
    copy_repeated(from, width, first - low,
                  {target.x, target.y + first, target.width, last - first});
    fill_rect({target.x, target.y + last, target.width, target.height - last},
              scenery.recipe->sky[2]);
    glScissor(target.x, target.y, target.width, target.height);
}

void BackdropPainter::copy_ground(const PaintedBackdrop& scenery, const Camera& camera,
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
void BackdropPainter::draw_shaped_ground(const PaintedBackdrop& scenery, const GroundShape& shape,
                                         const Camera& camera, const PixelRect& target) {
    const double scale = camera.pixels_per_metre;
    const Vec2 origin =
        scale * camera.center - 0.5 * Vec2(target.width, target.height);  // of the view, in pixels
    fill_behind_ground(*scenery.recipe, target, surface_of(camera, target, shape.level), scale);
    glViewport(target.x, target.y, target.width, target.height);
    slope_.use();
    give(slope_, "size", target.width, target.height);
    give(slope_, "view", target.x, target.y);
    give(slope_, "tile", scenery.ground->width(), scenery.ground->height(),
         wrapped(origin.x(), scenery.ground->width()));
    give(slope_, "deep", deep_soil(*scenery.recipe));
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
        slope_.use();
        scenery.ground->bind_to_sample();
        give(slope_, "line", from.x(), from.y(), steepness);
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
