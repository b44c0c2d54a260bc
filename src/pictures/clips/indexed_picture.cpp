#include "pictures/clips/indexed_picture.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cambrian {
namespace {

// A pixel keeps its colour while that is within this of the right one (see color_distance()): about
// four levels.
constexpr int kUnseenDistance = 140;

// Bayer's pattern, from -4 to 3.
constexpr std::array<std::array<int, 4>, 4> kPattern = {
    {{{-4, 0, -3, 1}}, {{2, -2, 3, -1}}, {{-3, 1, -4, 0}}, {{3, -1, 2, -2}}}};

std::uint8_t shifted(std::uint8_t level, int by) {
    return static_cast<std::uint8_t>(std::clamp(level + by, 0, 255));
}

}  // namespace

PictureIndexer::PictureIndexer(ColorTable colors, int width, int height, bool dithered)
    : table_(std::move(colors)),
      width_(width),
      height_(height),
      dithered_(dithered),
      shown_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), kUnchanged),
      whole_{0, 0, width, height, std::vector<std::uint8_t>(shown_.size())} {}

std::uint8_t PictureIndexer::index_of(const std::uint8_t* rgb, std::uint8_t shown, int x, int y) {
    const bool seen = shown != kUnchanged;
    if (!dithered_) {
        if (seen && color_distance(rgb, table_.colors()[shown - 1U].data()) <= kUnseenDistance)
            return kUnchanged;
        const auto index = static_cast<std::uint8_t>(table_.nearest(rgb) + 1);
        return index == shown ? kUnchanged : index;
    }
    const int by = kPattern[static_cast<std::size_t>(y & 3)][static_cast<std::size_t>(x & 3)];
    const Rgb mixed = {shifted(rgb[0], by), shifted(rgb[1], by), shifted(rgb[2], by)};
    const auto index = static_cast<std::uint8_t>(table_.nearest(mixed.data()) + 1);
    return index == shown ? kUnchanged : index;
}

const IndexedPicture& PictureIndexer::next(const Image& picture) {
    std::size_t at = 0;
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x, ++at) {
            const std::uint8_t index = index_of(picture.rgb.data() + 3 * at, shown_[at], x, y);
            whole_.indices[at] = index;
            if (index != kUnchanged) shown_[at] = index;
        }
    }
    crop();
    return changed_;
}

// Cuts off the lines and columns at the edges in which nothing changed.
void PictureIndexer::crop() {
    int top = height_;
    int bottom = 0;
    int left = width_;
    int right = 0;
    for (int y = 0; y < height_; ++y) {
        const std::uint8_t* const line = whole_.row(y);
        const std::uint8_t* const end = line + width_;
        const auto is_new = [](std::uint8_t index) { return index != kUnchanged; };
        const std::uint8_t* const first = std::find_if(line, end, is_new);
        if (first == end) continue;
        const auto last = std::find_if(std::make_reverse_iterator(end),
                                       std::make_reverse_iterator(first), is_new);
        top = std::min(top, y);
        bottom = y + 1;
        left = std::min(left, static_cast<int>(first - line));
        right = std::max(right, static_cast<int>(last.base() - line));
    }
    if (bottom == 0) top = left = 0;
    changed_.x = left;
    changed_.y = top;
    changed_.width = std::max(1, right - left);
    changed_.height = std::max(1, bottom - top);
    changed_.indices.clear();
    for (int y = 0; y < changed_.height; ++y) {
        const std::uint8_t* const from = whole_.row(top + y) + left;
        changed_.indices.insert(changed_.indices.end(), from, from + changed_.width);
    }
}

}  // namespace cambrian
