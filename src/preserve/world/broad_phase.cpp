#include "preserve/world/broad_phase.h"

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

// If images reach beyond an edge, those count in which one of the two has its lower end in the
// area. So each image of a pair counts once.
bool counts(std::int32_t laps_of_a, std::int32_t laps_of_b) {
    return laps_of_a == 0 || laps_of_b == 0;
}

}  // namespace

void BroadPhase::add_copies(const Bounds& bounds, std::uint32_t index) {
    if (!torus_.meets()) {
        copies_.push_back({bounds, {}, {}, index});
        return;
    }
    const Periods home = torus_.image_of(bounds.low);
    const Bounds there = moved(bounds, -torus_.shift_of(home));
    const Vec3 edge(-0.5 * torus_.width, -0.5 * torus_.height, 0.0);
    Periods laps;
    do {
        laps.x = 0;
        do {
            const Bounds copy = moved(there, -torus_.shift_of(laps));
            copies_.push_back({copy, laps, home + laps, index});
            ++laps.x;
        } while (torus_.width > 0.0 && there.high.x() - laps.x * torus_.width >= edge.x());
        ++laps.y;
    } while (torus_.height > 0.0 && there.high.y() - laps.y * torus_.height >= edge.y());
}

void BroadPhase::enter(std::uint32_t copy) {
    const Bounds& bounds = copies_[copy].bounds;
    for (std::int32_t r = meeting_cell(bounds.low.y()); r <= meeting_cell(bounds.high.y()); ++r) {
        for (std::int32_t c = meeting_cell(bounds.low.x()); c <= meeting_cell(bounds.high.x()); ++c)
            entries_.push_back({r, c, copy});
    }
}

// Takes a pair in the one cell that has the lower left corner of what the two have in common.
void BroadPhase::add_pair(const Copy& a, const Copy& b, const Entry& cell) {
    if (!overlap(a.bounds, b.bounds) || a.index == b.index) return;
    if (!counts(a.laps.x, b.laps.x) || !counts(a.laps.y, b.laps.y)) return;
    if (meeting_cell(std::max(a.bounds.low.y(), b.bounds.low.y())) == cell.row &&
        meeting_cell(std::max(a.bounds.low.x(), b.bounds.low.x())) == cell.column)
        pairs_.push_back({a.index, b.index, a.image - b.image});
}

std::span<const BroadPhase::Pair> BroadPhase::find(std::span<const Bounds> bounds) {
    copies_.clear();
    entries_.clear();
    pairs_.clear();
    for (std::uint32_t i = 0; i < bounds.size(); ++i)
        add_copies(bounds[i], i);
    for (std::uint32_t copy = 0; copy < copies_.size(); ++copy)
        enter(copy);
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.row, a.column, a.copy) < std::tie(b.row, b.column, b.copy);
    });
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& first = entries_[i];
        for (std::size_t j = i + 1; j < entries_.size(); ++j) {
            const Entry& second = entries_[j];
            if (second.row != first.row || second.column != first.column) break;
            add_pair(copies_[first.copy], copies_[second.copy], first);
        }
    }
    std::sort(pairs_.begin(), pairs_.end());
    return pairs_;
}

}  // namespace cambrian
