#include "simulator/surroundings/loudness_sum.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace cambrian {
namespace {

constexpr double kCellSize = 4.0;  // m
constexpr double kFaint = 0.01;    // loudness that nobody hears

int cell_of(double coordinate) {
    constexpr double most = 1e8;  // far outside of any world
    return static_cast<int>(std::clamp(std::floor(coordinate / kCellSize), -most, most));
}

}  // namespace

void LoudnessSum::reserve(std::size_t sounds) {
    sounds_.reserve(sounds);
    cells_.reserve(sounds);
}

void LoudnessSum::clear() {
    sounds_.clear();
    cells_.clear();
}

void LoudnessSum::add(const Sound& sound, std::uint32_t creature) {
    if (!(sound.loudness > kFaint)) return;
    sounds_.push_back({sound, creature, static_cast<std::uint32_t>(sounds_.size()),
                       cell_of(sound.place.x()), cell_of(sound.place.y())});
}

void LoudnessSum::finish() {
    const auto order = [](const Heard& a) {
        return std::tuple(a.sound.band, a.cell_y, a.cell_x, a.creature, a.number);
    };
    std::sort(sounds_.begin(), sounds_.end(),
              [&](const Heard& a, const Heard& b) { return order(a) < order(b); });
    cells_.clear();
    for (std::size_t i = 0; i < sounds_.size(); ++i) {
        const Heard& heard = sounds_[i];
        const bool same = !cells_.empty() && cells_.back().band == heard.sound.band &&
                          cells_.back().x == heard.cell_x && cells_.back().y == heard.cell_y;
        if (!same) cells_.push_back({heard.sound.band, heard.cell_x, heard.cell_y, i, i});
        Cell& cell = cells_.back();
        cell.end = i + 1;
        cell.loudness += heard.sound.loudness;
        cell.center += heard.sound.loudness * heard.sound.place;
    }
    for (Cell& cell : cells_)
        cell.center /= cell.loudness;
}

// Returns whether an image of the cell, across an edge, is about as near as the cells beside that
// of the point.
bool LoudnessSum::is_near_across(const Cell& cell, const Vec3& point) const {
    const Vec3 way = cell.center - point;
    const Vec3 nearest = torus_.shortest(way);
    return nearest != way && nearest.cwiseAbs().maxCoeff() < 2.0 * kCellSize;
}

bool LoudnessSum::is_of(const Cell& cell, std::uint32_t creature) const {
    return std::any_of(sounds_.begin() + static_cast<std::ptrdiff_t>(cell.begin),
                       sounds_.begin() + static_cast<std::ptrdiff_t>(cell.end),
                       [&](const Heard& heard) { return heard.creature == creature; });
}

double LoudnessSum::exact(const Cell& cell, const Vec3& point, std::uint32_t creature) const {
    double sum = 0.0;
    for (std::size_t i = cell.begin; i < cell.end; ++i) {
        const Heard& heard = sounds_[i];
        if (heard.creature == creature) continue;
        const Vec3 way = torus_.shortest(heard.sound.place - point);
        sum += loudness_at(way.norm(), heard.sound.loudness);
    }
    return sum;
}

double LoudnessSum::at(const Vec3& point, int band, std::uint32_t creature) const {
    const int x = cell_of(point.x());
    const int y = cell_of(point.y());
    double sum = 0.0;
    for (const Cell& cell : cells_) {
        if (cell.band != band) continue;
        const bool near =
            (std::abs(cell.x - x) <= 1 && std::abs(cell.y - y) <= 1) || is_near_across(cell, point);
        sum += near || is_of(cell, creature)
                   ? exact(cell, point, creature)
                   : loudness_at(torus_.shortest(cell.center - point).norm(), cell.loudness);
    }
    return sum;
}

}  // namespace cambrian
