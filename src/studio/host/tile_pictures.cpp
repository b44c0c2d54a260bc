#include "studio/host/tile_pictures.h"

#include "math/bounds.h"
#include "pictures/scene/living_look.h"
#include "pictures/scene/space_being.h"
#include "render/opengl/gl.h"
#include "render/orbit_camera.h"

#include <algorithm>
#include <bit>
#include <memory>
#include <utility>

namespace cambrian {
namespace {

constexpr int kPageSide = 1024;  // pixels
constexpr std::size_t kMostPages = 8;
constexpr double kMostScale = 60.0;  // pixels per metre, before the display's scale
constexpr double kRoom = 1.06;       // of a body's size, for its outline

class BodyHash {
public:
    void add(double number) {
        bits_ ^= std::bit_cast<std::uint64_t>(number);
        bits_ *= 0xBF58476D1CE4E5B9U;
        bits_ ^= bits_ >> 29U;
    }
    std::uint64_t bits() const { return bits_; }

private:
    std::uint64_t bits_ = 0x9E3779B97F4A7C15U;
};

Bounds bounds_at_rest(const BodyPlan& plan) {
    Bounds bounds;
    for (const PlannedPart& part : plan.parts) {
        const Vec3& half = part.half_extents;
        for (const double x : {-half.x(), half.x()}) {
            for (const double y : {-half.y(), half.y()})
                bounds.add(transform(part.rest_pose, {x, y, 0.0}));
        }
    }
    return bounds;
}

// Restores what was bound when a picture has been drawn.
class Bound {
public:
    explicit Bound(const PaintedTexture& texture) {
        glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before_);
        texture.bind_to_draw();
    }
    ~Bound() {
        glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before_));
        glDisable(GL_SCISSOR_TEST);
    }
    Bound(const Bound&) = delete;
    Bound& operator=(const Bound&) = delete;

private:
    GLint before_ = 0;
};

}  // namespace

std::size_t TilePictures::Page::columns() const {
    return static_cast<std::size_t>(kPageSide / width);
}

std::size_t TilePictures::Page::cells() const {
    return columns() * static_cast<std::size_t>(kPageSide / height);
}

TilePictures::Key TilePictures::key_of(const TileWish& wish) {
    BodyHash hash;
    for (std::size_t i = 0; i < wish.phenotype.parts.size(); ++i) {
        const PlannedPart& part = wish.phenotype.plan.parts[i];
        for (const double number :
             {part.half_extents.x(), part.half_extents.y(), part.rest_pose.position.x(),
              part.half_extents.z(), part.rest_pose.position.z(), part.rest_pose.orientation.x(),
              part.rest_pose.orientation.y(), part.rest_pose.position.y(), part.rest_angle,
              static_cast<double>(wish.phenotype.parts[i].node)})
            hash.add(number);
    }
    return {hash.bits(), wish.line,
            wish.hue,    wish.width,
            wish.height, lives_in_space(wish.phenotype) && ui().look == LookMode::kMechanics};
}

// Returns a page with a free cell of this size: one there is, a new one, or the one that was used
// longest ago, emptied.
std::optional<std::size_t> TilePictures::page_for(int width, int height) {
    for (std::size_t i = 0; i < pages_.size(); ++i) {
        const Page& page = pages_[i];
        if (page.width == width && page.height == height && page.used < page.cells()) return i;
    }
    if (pages_.size() < kMostPages) {
        auto texture = PaintedTexture::create(kPageSide, kPageSide);
        if (!texture) return std::nullopt;
        pages_.push_back({std::move(*texture), width, height});
        return pages_.size() - 1;
    }
    const auto oldest =
        std::min_element(pages_.begin(), pages_.end(),
                         [](const Page& a, const Page& b) { return a.asked < b.asked; });
    const auto index = static_cast<std::size_t>(oldest - pages_.begin());
    std::erase_if(places_, [index](const auto& each) { return each.second.page == index; });
    oldest->width = width;
    oldest->height = height;
    oldest->used = 0;
    return index;
}

void TilePictures::paint(const TileWish& wish, const Place& place) {
    const Page& page = pages_[place.page];
    const Bounds bounds = bounds_at_rest(wish.phenotype.plan);
    // The body stands on the ground.
    const Vec3 lift(0.0, -bounds.low.y(), 0.0);
    std::vector<Pose> poses;
    for (const PlannedPart& part : wish.phenotype.plan.parts)
        poses.push_back({part.rest_pose.position + lift, part.rest_pose.orientation});
    const Vec3 size = (kRoom * (bounds.high - bounds.low)).cwiseMax(0.01);
    Camera camera;
    camera.center = (0.5 * (bounds.low + bounds.high) + lift).head<2>();
    camera.pixels_per_metre = std::min({wish.width / size.x(), wish.height / size.y(),
                                        kMostScale * static_cast<double>(ui().scale)});
    const int column = static_cast<int>(place.cell % page.columns());
    const int row = static_cast<int>(place.cell / page.columns());
    draw(wish, poses, camera, page.texture,
         {column * page.width, row * page.height, page.width, page.height});
}

void TilePictures::draw(const TileWish& wish, std::span<const Pose> poses, const Camera& camera,
                        const PaintedTexture& texture, const PixelRect& target) {
    CreatureLook look{wish.phenotype, poses};
    look.hue = wish.hue;
    if (lives_in_space(wish.phenotype)) return draw_in_space(wish, look, camera, texture, target);
    if (wish.moment != nullptr) {
        look.character = wish.moment->character;
        look.stretches = wish.moment->stretches;
    }
    look.character.line = wish.line;
    SceneFrame frame;
    // Transparent, in the colour of outlines, which edges fade to.
    frame.background = color_of(0x2A211C, 0.0F);
    add_being(frame, colors(), camera, look);
    const Bound bound(texture);
    renderer_.draw(frame, camera, target);
}

void TilePictures::draw_in_space(const TileWish& wish, CreatureLook& look, const Camera& camera,
                                 const PaintedTexture& texture, const PixelRect& target) {
    constexpr double kShare = 0.94;  // of the tile, for a body at rest
    const Viewport size{static_cast<double>(target.width), static_cast<double>(target.height)};
    OrbitCamera orbit;
    std::vector<Vec3> corners;
    add_corners(corners, wish.phenotype, look.poses);
    orbit.fit(corners, kShare, size);
    auto space = std::make_shared<SpaceFrame>();
    space->camera = orbit.seen(size);
    const double most = wish.moment != nullptr ? camera.pixels_per_metre
                                               : kMostScale * static_cast<double>(ui().scale);
    if (wish.moment != nullptr) space->camera.target = wish.moment->middle;
    if (wish.moment != nullptr || space->camera.pixels_per_metre > most)
        space->camera.pixels_per_metre = most;
    space->clear = true;
    space->samples = 2;
    space->outline = 1.0;
    space->light.above = color_of(0xDDE6EA);
    space->light.below = color_of(0x6A6058);
    space->light.haze_from = 1e6;
    look.mode = ui().look == LookMode::kMechanics ? LookMode::kMechanics : LookMode::kLife;
    look.character = {};
    look.character.line = wish.line;
    if (wish.moment != nullptr) look.character.time = wish.moment->character.time;
    add_being(*space, look, {});
    SceneFrame frame;
    frame.space = std::move(space);
    const Bound bound(texture);
    renderer_.draw(frame, camera, target);
}

std::optional<TilePicture> TilePictures::moving(const TileWish& wish) {
    std::optional<PaintedTexture>& texture = moving_[turn_++ % moving_.size()];
    if (!texture || texture->width() != wish.width || texture->height() != wish.height) {
        texture.reset();
        auto made = PaintedTexture::create(wish.width, wish.height);
        if (!made) return std::nullopt;
        texture.emplace(std::move(*made));
    }
    draw(wish, wish.moment->poses, wish.moment->camera, *texture, {0, 0, wish.width, wish.height});
    return TilePicture{
        std::bit_cast<ImTextureID>(std::uintptr_t{texture->name()}), {0.0F, 1.0F}, {1.0F, 0.0F}};
}

std::optional<TilePicture> TilePictures::of(const TileWish& wish) {
    if (wish.width > kPageSide || wish.height > kPageSide) return std::nullopt;
    if (wish.moment != nullptr) return moving(wish);
    const Key key = key_of(wish);
    auto found = places_.find(key);
    if (found == places_.end()) {
        const auto page = page_for(wish.width, wish.height);
        if (!page) return std::nullopt;
        const Place place{*page, pages_[*page].used++};
        paint(wish, place);
        found = places_.emplace(key, place).first;
    }
    Page& page = pages_[found->second.page];
    page.asked = ++wishes_;
    constexpr float kSide = kPageSide;
    const auto row = found->second.cell / page.columns();
    const auto column = found->second.cell % page.columns();
    const auto left = static_cast<float>(column) * static_cast<float>(page.width);
    const auto foot = static_cast<float>(row) * static_cast<float>(page.height);
    return TilePicture{std::bit_cast<ImTextureID>(std::uintptr_t{page.texture.name()}),
                       {left / kSide, (foot + static_cast<float>(page.height)) / kSide},
                       {(left + static_cast<float>(page.width)) / kSide, foot / kSide}};
}

}  // namespace cambrian
