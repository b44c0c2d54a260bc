#include "pictures/scene/field_overlays.h"

#include "math/elementary.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

// Of the colour-blind-safe set of Okabe & Ito.
const std::array kBandColors = {color_of(0x56B4E9), color_of(0xE69F00), color_of(0x009E73),
                                color_of(0xD55E00)};
const Color kScentColor = color_of(0xCC79A7);

struct Ring {
    double heard = 0.0;  // loudness
    float alpha = 0.0F;
};
constexpr std::array kRings = {Ring{0.5, 0.9F}, Ring{0.25, 0.55F}, Ring{0.125, 0.3F}};

constexpr double kNoticed = 1e-3;    // units of scent; less is hardly noticed
constexpr double kFaintest = 0.05;   // reading of a nose that is left out
constexpr double kTint = 0.5;        // opacity for each unit of a reading
constexpr double kDensest = 0.6;     // opacity
constexpr double kTilePixels = 6.0;  // largest side of a drawn tile
constexpr int kMostTiles = 8;        // in a row of a cell

double tint_of(double amount) {
    const double reading = 0.25 * logarithm(1.0 + amount / kNoticed);
    return reading < kFaintest ? 0.0 : std::min(kTint * reading, kDensest);
}

// Tiles of a field that are in view, in units of a tile from its lower left corner.
struct Tiles {
    double side = kScentCell;  // m
    int left = 0, right = 0, bottom = 0, top = 0;
};

Tiles tiles_in_view(const ScentArea& area, const Camera& camera, const Viewport& viewport) {
    const double pixels = kScentCell / camera.pixel();
    const int split = std::clamp(static_cast<int>(std::ceil(pixels / kTilePixels)), 1, kMostTiles);
    const double side = kScentCell / split;
    const WorldWindow window = camera.window(viewport);
    const auto tile = [&](double place, double edge, int cells) {
        const double all = static_cast<double>(cells) * split;
        return static_cast<int>(std::clamp(std::floor((place - edge) / side), 0.0, all));
    };
    return {.side = side,
            .left = tile(window.low.x(), area.left, area.columns),
            .right = tile(window.high.x() + side, area.left, area.columns),
            .bottom = tile(window.low.y(), area.bottom, area.rows),
            .top = tile(window.high.y() + side, area.bottom, area.rows)};
}

// Returns the nearest corner of a pixel. Edges that tiles share leave seams unless they lie there.
Vec2 at_pixel(const Vec2& point, const WorldWindow& window, double pixel) {
    const Vec2 pixels = (point - window.low) / pixel;
    return window.low + pixel * Vec2(std::round(pixels.x()), std::round(pixels.y()));
}

}  // namespace

void add_sounds(SceneFrame& frame, const Camera& camera, std::span<const Sound> sounds) {
    const double width = 1.5 * camera.pixel();
    for (const Sound& sound : sounds) {
        if (!(sound.loudness > 0.0)) continue;
        const Color& color = kBandColors[static_cast<std::size_t>(sound.band)];
        const Vec2 center = sound.place.head<2>();
        frame.add_circle(center, 2.5 * width, color);
        for (const Ring& ring : kRings) {
            const double radius = sound.loudness / ring.heard - 1.0;
            if (radius > 0.0) frame.add_ring(center, radius, width, with_alpha(color, ring.alpha));
        }
    }
}

void add_scent(SceneFrame& frame, const Camera& camera, const Viewport& viewport,
               const ScentField& field) {
    if (!field.any()) return;
    const ScentArea& area = field.area();
    const Tiles tiles = tiles_in_view(area, camera, viewport);
    const WorldWindow window = camera.window(viewport);
    const Vec2 half = Vec2::Constant(0.5 * tiles.side);
    for (int row = tiles.bottom; row < tiles.top; ++row) {
        for (int column = tiles.left; column < tiles.right; ++column) {
            const Vec2 center = Vec2(area.left + (column + 0.5) * tiles.side,
                                     area.bottom + (row + 0.5) * tiles.side);
            const double tint = tint_of(field.at({center.x(), center.y(), 0.0}));
            if (!(tint > 0.0)) continue;
            const Vec2 low = at_pixel(center - half, window, camera.pixel());
            const Vec2 high = at_pixel(center + half, window, camera.pixel());
            frame.add_box(0.5 * (low + high), 0.5 * (high - low),
                          with_alpha(kScentColor, static_cast<float>(tint)));
        }
    }
}

}  // namespace cambrian
