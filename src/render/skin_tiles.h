#pragma once

// Divides the picture of a skin into rectangles with the few boxes that matter in each. The smooth
// minimum of the boxes' distances has a finite reach, so that boxes farther away change nothing.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace cambrian {

inline constexpr std::size_t kTileBoxes = 4;

// A box of a skin in pixels from the target's lower left corner.
struct TileBox {
    float x = 0.0F;
    float y = 0.0F;
    float cosine = 1.0F;
    float sine = 0.0F;
    float half_x = 0.0F;
    float half_y = 0.0F;
    std::array<float, 4> radii = {};  // in the order of SkinBox::roundness
};

struct SkinTile {
    float x = 0.0F;  // pixels; lower left corner
    float y = 0.0F;
    float width = 0.0F;
    float height = 0.0F;
    std::array<std::uint8_t, kTileBoxes> boxes = {};  // from back to front
    std::uint8_t count = 0;                           // 1 to kTileBoxes

    bool has_boxes_of(const SkinTile& other) const {
        return count == other.count && boxes == other.boxes;
    }
};

// Returns the signed distance of a point to a box with its corners rounded, in pixels.
float distance_to_box(const TileBox& box, float x, float y);

// Adds the tiles of a skin within a target of this size; those with the same boxes follow each
// other. The first box is in front; those after kMostSkinBoxes are left out. `blend` is in pixels.
// Where more than kTileBoxes meet within 4 pixels, the farthest are left out.
void add_skin_tiles(std::vector<SkinTile>& tiles, std::span<const TileBox> boxes, float blend,
                    float width, float height);

}  // namespace cambrian
