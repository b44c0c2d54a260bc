#include "render/backdrop_pictures.h"

#include "render/backdrop_shaders.h"
#include "render/opengl/kept_framebuffers.h"
#include "render/uniforms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace cambrian {
namespace {

constexpr int kTileWidth = 1024;  // texels of a tile of ground
constexpr int kTileHeight = 512;
constexpr int kParts = 4;  // of each of sky, finished sky and tile
constexpr int kRidges = 3;
constexpr int kPaintingSteps = 3 * kParts + kRidges;  // in which a scenery is painted
constexpr double kTileMetres = 4.0;  // width of a tile, or this times a power of two

void give_size(const Shader& shader, const PaintedTexture& texture) {
    shader.use();
    give(shader, "size", texture.width(), texture.height());
}

// Returns one of the parts that a texture is painted in.
PixelRect part_of(const PaintedTexture& texture, int part) {
    const int low = texture.height() * part / kParts;
    const int high = texture.height() * (part + 1) / kParts;
    return {0, low, texture.width(), high - low};
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

bool PaintedBackdrop::is_finished() const {
    return steps >= kPaintingSteps;
}

Result<Shader> backdrop_shader(const char* source) {
    const std::string whole = std::string(backdrop::kNoiseSource) + source;
    return Shader::compile(backdrop::kVertexSource, whole.c_str());
}

Result<BackdropPictures> BackdropPictures::create() {
    std::vector<Shader> shaders;
    for (const char* source :
         {backdrop::kSkySource, backdrop::kFinishSource, backdrop::kRidgeSource,
          backdrop::kSoilSource, backdrop::kScaleSource}) {
        Result<Shader> shader = backdrop_shader(source);
        if (!shader) return shader.error();
        shaders.push_back(std::move(*shader));
    }
    return BackdropPictures(std::move(shaders));
}

BackdropPictures::BackdropPictures(std::vector<Shader> shaders) : shaders_(std::move(shaders)) {}

void BackdropPictures::cover(const PixelRect& part) {
    const auto left = static_cast<float>(part.x);
    const auto low = static_cast<float>(part.y);
    const auto right = static_cast<float>(part.x + part.width);
    const auto high = static_cast<float>(part.y + part.height);
    const std::array<float, RectangleBuffer::kFloats> corners = {
        left, low, right, low, left, high, left, high, right, low, right, high};
    rectangle_.fill(corners);
    rectangle_.draw(0, 1);
}

void BackdropPictures::bake(PaintedBackdrop& pictures, Baking baking) {
    const int last =
        baking == Baking::kAtOnce ? kPaintingSteps : std::min(kPaintingSteps, pictures.steps + 1);
    if (pictures.steps >= last) return;
    const KeptFramebuffers kept;
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    for (; pictures.steps < last; ++pictures.steps)
        paint_step(pictures);
    glEnable(GL_BLEND);
    glEnable(GL_SCISSOR_TEST);
}

void BackdropPictures::paint_step(PaintedBackdrop& pictures) {
    int step = pictures.steps;
    if (step < kParts) return paint_sky(pictures, step);
    step -= kParts;
    if (step < kParts) return finish_sky(pictures, step);
    step -= kParts;
    if (step < kRidges) return paint_ridge(pictures, static_cast<std::size_t>(step));
    if (pictures.recipe->has_ground) paint_tile(pictures, step - kRidges);
}

void BackdropPictures::paint_sky(PaintedBackdrop& pictures, int part) {
    const BackdropRecipe& recipe = *pictures.recipe;
    // What stands on the ground may be seen from above, so there is more sky than in one view.
    const int above = recipe.has_ground ? pictures.height / 4 : 0;
    if (part == 0) {
        Result<PaintedTexture> half =
            PaintedTexture::create(pictures.width / 2, (pictures.height + above) / 2);
        Result<PaintedTexture> far =
            PaintedTexture::create(pictures.width, pictures.height + above);
        if (!half || !far) return;
        pictures.half = std::move(*half);
        pictures.far = std::move(*far);
    }
    if (!pictures.half) return;
    pictures.half->bind_to_draw();
    const Shader& sky = shaders_[kSky];
    give_size(sky, *pictures.half);
    give(sky, "low", recipe.sky[0]);
    give(sky, "middle", recipe.sky[1]);
    give(sky, "high", recipe.sky[2]);
    const double begin = recipe.has_ground ? 0.5 * pictures.horizon() : 0.0;
    give(sky, "ranges", 0.5 * begin, 0.5 * (pictures.height - begin), 0.5 * pictures.height);
    glUniform2f(sky.uniform("weather"), recipe.clouds, recipe.shafts);
    cover(part_of(*pictures.half, part));
}

void BackdropPictures::finish_sky(PaintedBackdrop& pictures, int part) {
    if (!pictures.far) return;
    const BackdropRecipe& recipe = *pictures.recipe;
    pictures.far->bind_to_draw();
    pictures.half->bind_to_sample();
    const Shader& finish = shaders_[kFinish];
    give_size(finish, *pictures.far);
    const bool among_stars =
        recipe.body == HeavenlyBody::kEarth || recipe.body == HeavenlyBody::kCrescent;
    give(finish, "body", recipe.body_place.x() * pictures.width,
         recipe.body_place.y() * pictures.height,
         among_stars ? recipe.body_radius * pictures.height : 0.0);
    glUniform4f(finish.uniform("body_color"), recipe.body_color.r, recipe.body_color.g,
                recipe.body_color.b, recipe.body == HeavenlyBody::kEarth ? 1.0F : 0.0F);
    glUniform1f(finish.uniform("stars"), recipe.stars);
    glUniform2f(finish.uniform("ranges"), 0.25F * static_cast<float>(pictures.height),
                0.65F * static_cast<float>(pictures.height));
    cover(part_of(*pictures.far, part));
    if (part == kParts - 1) pictures.half.reset();
}

void BackdropPictures::paint_ridge(const PaintedBackdrop& pictures, std::size_t i) {
    if (!pictures.far) return;
    const BackdropRecipe& recipe = *pictures.recipe;
    const auto& [crest, foot] = recipe.ridges[i];
    const int chain = static_cast<int>(i);
    pictures.far->bind_to_draw();
    const Shader& ridge = shaders_[kRidge];
    give_size(ridge, *pictures.far);
    give(ridge, "form", static_cast<int>(recipe.form));
    // With ground, all stand on the horizon; else nearer ones lie deeper.
    const int high = pictures.height * (recipe.has_ground ? 24 - 3 * chain : 30) / 100;
    const int low =
        recipe.has_ground ? pictures.horizon() - 2 : high * (15 * (2 - chain) - 25) / 100;
    const int waves = (4 + 2 * chain) * pictures.width / PaintedBackdrop::kLeastWidth;
    glUniform4f(ridge.uniform("strip"), static_cast<float>(low), static_cast<float>(high),
                static_cast<float>(3 + 7 * chain), static_cast<float>(waves));
    give(ridge, "crest", crest);
    give(ridge, "foot", foot);
    const float shine = recipe.form == RidgeForm::kSeabed ? 0.03F : 0.12F;
    const Color glint = mix(crest, color_of(0xFFFFFF), 0.5F);
    give(ridge, "glint", static_cast<double>(shine * glint.r), static_cast<double>(shine * glint.g),
         static_cast<double>(shine * glint.b));
    glUniform1f(ridge.uniform("rough"), static_cast<float>(roughness(recipe.form, i)));
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    cover({0, low, pictures.far->width(), high});
    glDisable(GL_BLEND);
}

void BackdropPictures::paint_tile(PaintedBackdrop& pictures, int part) {
    if (part == 0) {
        if (Result<PaintedTexture> tile = PaintedTexture::create(kTileWidth, kTileHeight))
            pictures.tile = std::move(*tile);
    }
    if (!pictures.tile) return;
    pictures.tile->bind_to_draw();
    const Shader& soil = shaders_[kSoil];
    give_size(soil, *pictures.tile);
    const BackdropRecipe& recipe = *pictures.recipe;
    give(soil, "cover", recipe.ground[0]);
    give(soil, "upper", recipe.ground[1]);
    give(soil, "deep", recipe.ground[2]);
    give(soil, "stones", recipe.ground[3]);
    give(soil, "form", static_cast<int>(recipe.soil));
    cover(part_of(*pictures.tile, part));
}

void BackdropPictures::scale_ground(PaintedBackdrop& pictures, double pixels_per_metre) {
    const KeptFramebuffers kept;  // creating a texture binds it
    pictures.scale = pixels_per_metre;
    const int width =
        static_cast<int>(std::round(tile_metres(pixels_per_metre) * pixels_per_metre));
    Result<PaintedTexture> ground = PaintedTexture::create(width, kTileHeight * width / kTileWidth);
    if (!ground) {
        pictures.ground.reset();
        return;
    }
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    ground->bind_to_draw();
    pictures.tile->bind_to_sample();
    const Shader& scale = shaders_[kScale];
    give_size(scale, *ground);
    cover({0, 0, ground->width(), ground->height()});
    glEnable(GL_BLEND);
    glEnable(GL_SCISSOR_TEST);
    pictures.ground = std::move(*ground);
}

}  // namespace cambrian
