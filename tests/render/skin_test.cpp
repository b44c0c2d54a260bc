#include "render/opengl/framebuffer.h"
#include "render/opengl/offscreen_context.h"
#include "render/opengl/pixels.h"
#include "render/renderer.h"
#include "render/skin_tiles.h"
#include "support/catch.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace cambrian {
namespace {

constexpr int kSide = 160;  // pixels

struct Body {
    std::vector<TileBox> boxes;
    float blend = 0.0F;  // as creatures have it: a share of a square as large as all boxes
};

// A chain of boxes that fold onto each other, near the middle of the target.
Body random_body(std::mt19937& random, int parts) {
    std::uniform_real_distribution<float> share(0.0F, 1.0F);
    const float scale = std::sqrt(4.0F / static_cast<float>(std::max(parts, 4)));
    float area = 0.0F;
    Body body;
    float x = 0.5F * kSide;
    float y = 0.5F * kSide;
    for (int i = 0; i < parts; ++i) {
        const float angle = 6.2831853F * share(random);
        TileBox box;
        box.cosine = std::cos(angle);
        box.sine = std::sin(angle);
        box.half_x = scale * (6.0F + 22.0F * share(random));
        box.half_y = scale * (4.0F + 12.0F * share(random));
        area += 4.0F * box.half_x * box.half_y;
        x = std::clamp(x + box.cosine * box.half_x, 20.0F, kSide - 20.0F);
        y = std::clamp(y + box.sine * box.half_x, 20.0F, kSide - 20.0F);
        box.x = x;
        box.y = y;
        x += box.cosine * box.half_x;
        y += box.sine * box.half_x;
        box.radii.fill(0.6F * std::min(box.half_x, box.half_y));
        body.boxes.push_back(box);
    }
    body.blend = 0.11F * std::sqrt(area);
    return body;
}

// What a pixel shows, by the equations of the painter: how far out it is, and the place of the box
// in front on a scale of all boxes.
struct Shown {
    float coverage = 0.0F;
    float tint = 0.0F;
};

template <class Indices>
Shown shown_at(const Body& body, const Indices& back_to_front, float x, float y) {
    float depth = 0.0F;
    float tint = 0.0F;
    bool first = true;
    for (const std::size_t index : back_to_front) {
        const float here = distance_to_box(body.boxes[index], x, y);
        const float own = static_cast<float>(index) / static_cast<float>(body.boxes.size());
        if (first) {
            depth = here;
            tint = own;
        } else {
            const float step = std::clamp(0.5F + 0.5F * (here - depth) / body.blend, 0.0F, 1.0F);
            const float above = here - std::max(depth, 0.0F);
            float over = std::clamp(0.5F - 0.5F * above / (0.3F * body.blend + 0.75F), 0.0F, 1.0F);
            over = over * over * (3.0F - 2.0F * over);
            tint += over * (own - tint);
            depth = here + step * (depth - here) - body.blend * step * (1.0F - step);
        }
        first = false;
    }
    return {std::clamp(0.5F - depth, 0.0F, 1.0F), tint};
}

SceneFrame frame_of(const Body& body) {
    SceneFrame frame;
    for (const TileBox& tile : body.boxes) {
        SkinBox box;
        box.center = {static_cast<double>(tile.x), static_cast<double>(tile.y)};
        box.half_extents = {static_cast<double>(tile.half_x), static_cast<double>(tile.half_y)};
        box.angle = std::atan2(static_cast<double>(tile.sine), static_cast<double>(tile.cosine));
        box.fill = color_of(0xE0A060);
        frame.skin_boxes.push_back(box);
    }
    Skin skin;
    skin.boxes = body.boxes.size();
    skin.blend = static_cast<double>(body.blend);
    skin.outline_width = 1.5;
    skin.wave = 20.0;
    skin.pattern = SkinPattern::kSpots;
    frame.add_skin(skin);
    return frame;
}

// Draws frames of kSide metres, a pixel each.
class Easel {
public:
    Easel() {
        auto context = OffscreenContext::create();
        REQUIRE(context);
        context_ = std::move(*context);
        auto renderer = Renderer::create();
        REQUIRE(renderer);
        renderer_ = std::move(*renderer);
    }
    Image picture(const SceneFrame& frame) {
        auto framebuffer = Framebuffer::create(kSide, kSide);
        REQUIRE(framebuffer);
        framebuffer->bind();
        Camera camera;
        camera.pixels_per_metre = 1.0;
        camera.center = Vec2::Constant(0.5 * kSide);
        renderer_->draw(frame, camera, {0, 0, kSide, kSide});
        return read_pixels(kSide, kSide);
    }

private:
    std::unique_ptr<OffscreenContext> context_;
    std::unique_ptr<Renderer> renderer_;
};

TEST_CASE("each place of a skin has one tile, whose boxes are all that matter there",
          "[render][skin]") {
    std::mt19937 random(7);
    int seen = 0, differing = 0, inside = 0;
    for (int i = 0; i < 200; ++i) {
        const Body body = random_body(random, 2 + i % 15);
        std::vector<SkinTile> tiles;
        add_skin_tiles(tiles, body.boxes, body.blend, kSide, kSide);
        std::vector<std::size_t> all;
        for (std::size_t box = body.boxes.size(); box-- > 0;)
            all.push_back(box);
        for (int y = 1; y < kSide; y += 3) {
            for (int x = i % 3; x < kSide; x += 3) {
                const float at_x = static_cast<float>(x) + 0.5F;
                const float at_y = static_cast<float>(y) + 0.5F;
                const Shown wanted = shown_at(body, all, at_x, at_y);
                const auto here = [&](const SkinTile& tile) {
                    return at_x >= tile.x && at_x < tile.x + tile.width && at_y >= tile.y &&
                           at_y < tile.y + tile.height;
                };
                const auto count = std::count_if(tiles.begin(), tiles.end(), here);
                REQUIRE(count <= 1);
                Shown shown;
                if (count == 1) {
                    const SkinTile& tile = *std::find_if(tiles.begin(), tiles.end(), here);
                    shown = shown_at(body, std::span(tile.boxes).first(tile.count), at_x, at_y);
                }
                ++seen;
                if (wanted.coverage > 0.0F) ++inside;
                const bool same =
                    std::fabs(shown.coverage - wanted.coverage) < 0.02F &&
                    (wanted.coverage == 0.0F || std::fabs(shown.tint - wanted.tint) < 0.02F);
                if (!same) ++differing;
            }
        }
    }
    INFO(differing << " of " << seen << ", inside " << inside);
    // Where more than four boxes meet, some are left out.
    CHECK(differing < inside / 50);
}

TEST_CASE("a skin covers its boxes, and little beyond them", "[render][skin]") {
    Easel easel;
    std::mt19937 random(3);
    for (int i = 0; i < 12; ++i) {
        const Body body = random_body(random, 2 + i);
        const Image image = easel.picture(frame_of(body));
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                float least = 1e9F;
                for (const TileBox& box : body.boxes)
                    least = std::min(least, distance_to_box(box, static_cast<float>(x) + 0.5F,
                                                            static_cast<float>(y) + 0.5F));
                const std::uint8_t* pixel = image.pixel(x, kSide - 1 - y);
                const int light = pixel[0] + pixel[1] + pixel[2];
                if (least < -3.0F) REQUIRE(light > 60);
                if (least > 0.3F * body.blend + 2.0F) REQUIRE(light == 0);
            }
        }
    }
}

TEST_CASE("a skin has the same bytes whenever it is drawn, and after others", "[render][skin]") {
    std::mt19937 random(5);
    const SceneFrame frame = frame_of(random_body(random, 9));
    Easel easel;
    const Image first = easel.picture(frame);
    easel.picture(frame_of(random_body(random, 20)));
    CHECK(easel.picture(frame).rgb == first.rgb);
    CHECK(Easel().picture(frame).rgb == first.rgb);
}

TEST_CASE("shapes are drawn behind or in front of a skin, in the frame's order", "[render][skin]") {
    Easel easel;
    const auto middle = [&](const SceneFrame& frame) {
        const Image image = easel.picture(frame);
        const std::uint8_t* pixel = image.pixel(kSide / 2, kSide / 2);
        return std::array<int, 3>{pixel[0], pixel[1], pixel[2]};
    };
    const auto add_disc = [](SceneFrame& frame) {
        frame.add_circle(Vec2::Constant(0.5 * kSide), 5.0, color_of(0x0000FF));
    };
    const auto add_body = [](SceneFrame& frame) {
        SkinBox box;
        box.center = Vec2::Constant(0.5 * kSide);
        box.half_extents = {30.0, 20.0};
        box.fill = color_of(0xE0A060);
        frame.skin_boxes.push_back(box);
        Skin skin;
        skin.boxes = 1;
        skin.blend = 4.0;
        frame.add_skin(skin);
    };
    SceneFrame before, after;
    add_disc(before);
    add_body(before);
    add_body(after);
    add_disc(after);
    CHECK(middle(before)[0] > 150);
    CHECK(middle(after) == std::array<int, 3>{0, 0, 255});
}

}  // namespace
}  // namespace cambrian
