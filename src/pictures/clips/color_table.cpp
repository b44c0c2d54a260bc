#include "pictures/clips/color_table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cambrian {
namespace {

constexpr std::uint16_t kUnknown = 0xFFFF;
constexpr std::array<double, 3> kAxisWeights = {2.0, 4.0, 1.0};  // as in color_distance()

struct CountedColor {
    Rgb rgb = {};
    double count = 0.0;
};

std::vector<CountedColor> counted_colors(const ColorCensus& census) {
    std::vector<CountedColor> colors;
    for (std::size_t key = 0; key < census.counts().size(); ++key) {
        const std::uint32_t count = census.counts()[key];
        if (count == 0) continue;
        const auto level = [key](unsigned shift) {
            const auto half = static_cast<std::uint8_t>((key >> shift) & 0x7FU);
            return static_cast<std::uint8_t>(half << 1U | half >> 6U);
        };
        // The root lets a small creature have colours of its own before a large sky.
        colors.push_back({{level(14), level(7), level(0)}, std::sqrt(static_cast<double>(count))});
    }
    return colors;
}

// A set of colours with their mean and its error.
struct ColorSet {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::array<double, 3> mean = {};
    std::size_t axis = 0;  // of the largest error
    double error = 0.0;    // of all axes
};

ColorSet set_of(const std::vector<CountedColor>& colors, std::size_t begin, std::size_t end) {
    ColorSet set{begin, end};
    double count = 0.0;
    std::array<double, 3> squares = {};
    for (std::size_t i = begin; i < end; ++i) {
        count += colors[i].count;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double level = colors[i].rgb[axis];
            set.mean[axis] += colors[i].count * level;
            squares[axis] += colors[i].count * level * level;
        }
    }
    double largest = -1.0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        set.mean[axis] /= count;
        const double error =
            kAxisWeights[axis] * (squares[axis] - count * set.mean[axis] * set.mean[axis]);
        set.error += error;
        if (error > largest) {
            largest = error;
            set.axis = axis;
        }
    }
    if (end - begin < 2) set.error = 0.0;
    return set;
}

// Divides a set at its mean; each part has at least one colour.
std::array<ColorSet, 2> divided(std::vector<CountedColor>& colors, const ColorSet& set) {
    const auto at = [&colors](std::size_t place) {
        return colors.begin() + static_cast<std::ptrdiff_t>(place);
    };
    const auto middle = std::stable_partition(
        at(set.begin), at(set.end),
        [&set](const CountedColor& color) { return color.rgb[set.axis] < set.mean[set.axis]; });
    const auto place = static_cast<std::size_t>(middle - colors.begin());
    const std::size_t split = std::clamp(place, set.begin + 1, set.end - 1);
    return {set_of(colors, set.begin, split), set_of(colors, split, set.end)};
}

Rgb rounded(const std::array<double, 3>& mean) {
    Rgb rgb;
    for (std::size_t axis = 0; axis < 3; ++axis)
        rgb[axis] = static_cast<std::uint8_t>(std::clamp(mean[axis] + 0.5, 0.0, 255.0));
    return rgb;
}

}  // namespace

void ColorCensus::add(const Image& picture) {
    counts_.resize(kColors);
    for (std::size_t at = 0; at + 2 < picture.rgb.size(); at += 3) {
        std::uint32_t& count = counts_[key_of(picture.rgb.data() + at)];
        if (count < std::numeric_limits<std::uint32_t>::max()) ++count;
    }
}

ColorTable::ColorTable(const ColorCensus& census, std::size_t most)
    : known_(ColorCensus::kColors, kUnknown) {
    std::vector<CountedColor> colors = counted_colors(census);
    if (colors.empty()) colors.push_back({{}, 1.0});
    std::vector<ColorSet> sets = {set_of(colors, 0, colors.size())};
    while (sets.size() < most) {
        const auto worst = std::max_element(
            sets.begin(), sets.end(),
            [](const ColorSet& one, const ColorSet& other) { return one.error < other.error; });
        if (worst->error <= 0.0) break;
        const auto [low, high] = divided(colors, *worst);
        *worst = low;
        sets.push_back(high);
    }
    for (const ColorSet& set : sets)
        colors_.push_back(rounded(set.mean));
}

std::size_t ColorTable::nearest(const std::uint8_t* rgb) {
    std::uint16_t& known = known_[ColorCensus::key_of(rgb)];
    if (known != kUnknown) return known;
    int least = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < colors_.size(); ++i) {
        const int distance = color_distance(rgb, colors_[i].data());
        if (distance >= least) continue;
        least = distance;
        known = static_cast<std::uint16_t>(i);
    }
    return known;
}

}  // namespace cambrian
