#include "render/skin_tiles.h"

#include "render/skin.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace cambrian {
namespace {

constexpr float kEdge = 1.5F;  // pixels around a skin that it may colour
// Boxes matter to each other up to these multiples of the blend.
constexpr float kReach = 1.0F;      // their difference in distance
constexpr float kLift = 0.3F;       // how much farther out a melted outline may be
constexpr float kSoftEdge = 0.3F;   // half the width of the edge of a box over others
constexpr float kLeastTile = 4.0F;  // pixels
constexpr float kHalfDiagonal = 0.70710678F;

struct Square {
    float x = 0.0F;
    float y = 0.0F;
    float side = 0.0F;
};

// Some boxes by index, from back to front, with the distance of each to a square's middle.
struct NearBoxes {
    std::array<std::uint8_t, kMostSkinBoxes> index = {};
    std::array<float, kMostSkinBoxes> distance = {};
    std::size_t count = 0;

    void add(std::uint8_t box, float how_far) {
        index[count] = box;
        distance[count++] = how_far;
    }
    // Drops the farthest box, or the one at the back if all are here.
    void drop_least() {
        const auto last = distance.begin() + static_cast<std::ptrdiff_t>(count);
        auto far = std::max_element(distance.begin(), last) - distance.begin();
        if (distance[static_cast<std::size_t>(far)] < 0.0F) far = 0;
        std::copy(distance.begin() + far + 1, last, distance.begin() + far);
        std::copy(index.begin() + far + 1, index.begin() + static_cast<std::ptrdiff_t>(count),
                  index.begin() + far);
        --count;
    }
};

class Splitter {
public:
    Splitter(std::vector<SkinTile>& tiles, std::span<const TileBox> boxes, float blend)
        : tiles_(tiles), boxes_(boxes), blend_(blend) {}

    void split(const NearBoxes& candidates, const Square& square) {
        NearBoxes near = near_boxes(candidates, square);
        if (near.count == 0) return;
        if (near.count > kTileBoxes && square.side > kLeastTile) {
            const float side = 0.5F * square.side;
            for (const float y : {square.y, square.y + side}) {
                for (const float x : {square.x, square.x + side})
                    split(near, {x, y, side});
            }
            return;
        }
        while (near.count > kTileBoxes)
            near.drop_least();
        SkinTile tile{square.x, square.y, square.side, square.side};
        tile.count = static_cast<std::uint8_t>(near.count);
        std::copy_n(near.index.begin(), near.count, tile.boxes.begin());
        tiles_.push_back(tile);
    }

private:
    NearBoxes near_boxes(const NearBoxes& candidates, const Square& square) const {
        const float reach = kHalfDiagonal * square.side;
        NearBoxes all;
        float least = 1e9F;
        for (std::size_t i = 0; i < candidates.count; ++i) {
            const std::uint8_t box = candidates.index[i];
            all.add(box, distance_to_box(boxes_[box], square.x + 0.5F * square.side,
                                         square.y + 0.5F * square.side));
            least = std::min(least, all.distance[i]);
        }
        NearBoxes near;
        // Outlines are lifted only where boxes melt.
        const auto melting = std::count_if(
            all.distance.begin(), all.distance.begin() + static_cast<std::ptrdiff_t>(all.count),
            [&](float each) { return each < least + 2.0F * reach + blend_; });
        if (least - reach - (melting > 1 ? kLift * blend_ : 0.0F) > kEdge) return near;
        const float farthest = std::max(least + reach, 0.0F) + kReach * blend_;
        // A box that covers all of the square hides those behind it.
        std::size_t behind = all.count;
        while (behind > 1 && all.distance[behind - 1] + reach > -(kSoftEdge * blend_ + kEdge))
            --behind;
        for (std::size_t i = behind - 1; i < all.count; ++i) {
            if (all.distance[i] - reach < farthest) near.add(all.index[i], all.distance[i]);
        }
        return near;
    }

    std::vector<SkinTile>& tiles_;
    std::span<const TileBox> boxes_;
    float blend_;
};

// Joins tiles beside each other that have the same boxes, and brings those of the same boxes
// together.
void join(std::vector<SkinTile>& tiles, std::size_t first) {
    const auto begin = tiles.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, tiles.end(), [](const SkinTile& a, const SkinTile& b) {
        return std::tie(a.count, a.boxes, a.height, a.y, a.x) <
               std::tie(b.count, b.boxes, b.height, b.y, b.x);
    });
    auto kept = begin;
    for (auto tile = begin; tile != tiles.end(); ++tile) {
        const bool joins = tile != begin && kept->has_boxes_of(*tile) &&
                           kept->height == tile->height && kept->y == tile->y &&
                           kept->x + kept->width == tile->x;
        if (joins) {
            kept->width += tile->width;
        } else {
            if (tile != begin) ++kept;
            *kept = *tile;
        }
    }
    if (begin != tiles.end()) tiles.erase(kept + 1, tiles.end());
}

}  // namespace

float distance_to_box(const TileBox& box, float x, float y) {
    const float right = x - box.x;
    const float up = y - box.y;
    const float along = box.cosine * right + box.sine * up;
    const float across = box.cosine * up - box.sine * right;
    const std::size_t corner = (along > 0.0F ? 0U : 1U) + (across > 0.0F ? 0U : 2U);
    const float radius = box.radii[corner];
    const float beyond_x = std::fabs(along) - box.half_x + radius;
    const float beyond_y = std::fabs(across) - box.half_y + radius;
    const float outside_x = std::max(beyond_x, 0.0F);
    const float outside_y = std::max(beyond_y, 0.0F);
    return std::sqrt(outside_x * outside_x + outside_y * outside_y) +
           std::min(std::max(beyond_x, beyond_y), 0.0F) - radius;
}

void add_skin_tiles(std::vector<SkinTile>& tiles, std::span<const TileBox> boxes, float blend,
                    float width, float height) {
    NearBoxes all;
    float left = width, bottom = height, right = 0.0F, top = 0.0F;
    for (std::size_t i = std::min(boxes.size(), kMostSkinBoxes); i-- > 0;) {
        const TileBox& box = boxes[i];
        all.add(static_cast<std::uint8_t>(i), 0.0F);
        const float reach_x = std::fabs(box.cosine) * box.half_x + std::fabs(box.sine) * box.half_y;
        const float reach_y = std::fabs(box.sine) * box.half_x + std::fabs(box.cosine) * box.half_y;
        left = std::min(left, box.x - reach_x);
        right = std::max(right, box.x + reach_x);
        bottom = std::min(bottom, box.y - reach_y);
        top = std::max(top, box.y + reach_y);
    }
    const float margin = kEdge + kLift * blend;
    left = std::max(0.0F, std::floor(left - margin));
    bottom = std::max(0.0F, std::floor(bottom - margin));
    right = std::min(width, right + margin);
    top = std::min(height, top + margin);
    if (left >= right || bottom >= top) return;
    const float extent = std::max(right - left, top - bottom);
    const float side = extent > 300.0F ? 32.0F : extent > 48.0F ? 16.0F : 8.0F;
    const std::size_t first = tiles.size();
    Splitter splitter(tiles, boxes, blend);
    // Sides are whole numbers of pixels, so that the sums are exact.
    for (float y = bottom; y < top; y += side) {
        for (float x = left; x < right; x += side)
            splitter.split(all, {x, y, side});
    }
    join(tiles, first);
}

}  // namespace cambrian
