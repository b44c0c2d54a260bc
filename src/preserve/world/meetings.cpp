#include "preserve/world/meetings.h"

#include "preserve/world/rectangle.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace cambrian {
namespace {

constexpr double kMeetingCell = 2.0;  // m
// Cells farther from the origin count as the last ones, so that stray bodies cost no memory.
constexpr double kMostCells = 600.0;

std::int32_t meeting_cell(double coordinate) {
    return static_cast<std::int32_t>(
        std::clamp(std::floor(coordinate / kMeetingCell), -kMostCells, kMostCells));
}

}  // namespace

void Meetings::enter(const Bounds& bounds, std::uint32_t index) {
    for (std::int32_t r = meeting_cell(bounds.low.y()); r <= meeting_cell(bounds.high.y()); ++r) {
        for (std::int32_t c = meeting_cell(bounds.low.x()); c <= meeting_cell(bounds.high.x()); ++c)
            entries_.push_back({r, c, index});
    }
}

// A pair is taken in the one cell that has the lower left corner of what the two have in common.
std::span<const Meetings::Pair> Meetings::find(std::span<const Bounds> bounds) {
    entries_.clear();
    pairs_.clear();
    for (std::uint32_t i = 0; i < bounds.size(); ++i)
        enter(bounds[i], i);
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.row, a.column, a.index) < std::tie(b.row, b.column, b.index);
    });
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& first = entries_[i];
        for (std::size_t j = i + 1; j < entries_.size(); ++j) {
            const Entry& second = entries_[j];
            if (second.row != first.row || second.column != first.column) break;
            const Bounds& a = bounds[first.index];
            const Bounds& b = bounds[second.index];
            if (!overlap(a, b)) continue;
            if (meeting_cell(std::max(a.low.y(), b.low.y())) == first.row &&
                meeting_cell(std::max(a.low.x(), b.low.x())) == first.column)
                pairs_.emplace_back(first.index, second.index);
        }
    }
    std::sort(pairs_.begin(), pairs_.end());
    return pairs_;
}

}  // namespace cambrian
