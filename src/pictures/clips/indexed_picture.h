#pragma once

// Pictures of a clip as indices into its colours, each as what changed since the one before.

#include "pictures/clips/color_table.h"

#include <cstdint>
#include <vector>

namespace cambrian {

// Index of pixels that stay as they are.
inline constexpr std::uint8_t kUnchanged = 0;
// A clip's own colours have the indices from 1 on.
inline constexpr std::size_t kMostClipColors = 255;

// A rectangle of the clip's picture that holds all that changed; it is never empty.
struct IndexedPicture {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> indices;  // rows from the top

    const std::uint8_t* row(int line) const {
        return indices.data() + static_cast<std::ptrdiff_t>(line) * width;
    }
};

class PictureIndexer {
public:
    // With dithering, a fixed pattern mixes the colours between which a pixel is; it makes files
    // about twice as large.
    PictureIndexer(ColorTable colors, int width, int height, bool dithered);

    const std::vector<Rgb>& colors() const { return table_.colors(); }
    // Returns what is new in a picture of the clip's size; the first one is complete. The result is
    // valid until the next call.
    const IndexedPicture& next(const Image& picture);

private:
    std::uint8_t index_of(const std::uint8_t* rgb, std::uint8_t shown, int x, int y);
    void crop();

    ColorTable table_;
    int width_;
    int height_;
    bool dithered_;
    std::vector<std::uint8_t> shown_;  // index of each pixel so far
    IndexedPicture whole_;
    IndexedPicture changed_;
};

}  // namespace cambrian
