#pragma once

// The colours of formats that have few: chosen once for all pictures of a clip, so that none
// flickers.

#include "core/image.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace cambrian {

using Rgb = std::array<std::uint8_t, 3>;

// Counts how often colours occur; neighbours that differ by a step of 1/128 count as the same.
class ColorCensus {
public:
    void add(const Image& picture);
    bool empty() const { return counts_.empty(); }

    static constexpr std::size_t kColors = std::size_t{1} << 21;
    // Returns a number below kColors.
    static std::size_t key_of(const std::uint8_t* rgb) {
        return (std::size_t{rgb[0]} >> 1) << 14 | (std::size_t{rgb[1]} >> 1) << 7 |
               std::size_t{rgb[2]} >> 1;
    }
    // By key; empty without pictures.
    const std::vector<std::uint32_t>& counts() const { return counts_; }

private:
    std::vector<std::uint32_t> counts_;
};

// The colours that serve best for those counted: the sets with the largest error are divided at
// their mean until there are enough.
class ColorTable {
public:
    // Makes `most` colours or less, at least one.
    ColorTable(const ColorCensus& census, std::size_t most);

    const std::vector<Rgb>& colors() const { return colors_; }
    // Returns the index of a colour's nearest.
    std::size_t nearest(const std::uint8_t* rgb);

private:
    std::vector<Rgb> colors_;
    std::vector<std::uint16_t> known_;  // by key; the index, or kUnknown
};

// Returns how far apart two colours look: the square of a distance of which a step of one of green
// has 2.
inline int color_distance(const std::uint8_t* one, const std::uint8_t* other) {
    const int red = one[0] - other[0];
    const int green = one[1] - other[1];
    const int blue = one[2] - other[2];
    return 2 * red * red + 4 * green * green + blue * blue;
}

}  // namespace cambrian
