#include "preserve/world/food.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kCell = 1.0;       // m
constexpr Energy kNoPellet = 1000;  // less energy is not worth a pellet

int cells_in(double length) {
    return std::max(1, static_cast<int>(std::ceil(length / kCell)));
}

int cell_at(double distance, int count) {
    return static_cast<int>(std::clamp(std::floor(distance / kCell), 0.0, count - 1.0));
}

// Returns the part of an area in which pellets lie.
WorldArea layer_of(const WorldArea& area, double limit) {
    WorldArea layer = area;
    if (area.has_ground && !area.ground) layer.height = std::min(area.height, limit);
    return layer;
}

}  // namespace

Food::Food(const WorldArea& area, double limit)
    : area_(layer_of(area, limit)),
      limit_(limit),
      columns_(cells_in(area.width)),
      rows_(cells_in(area_.top() - area_.bottom())),
      cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

Vec3 Food::resting(const Vec3& place) const {
    Vec3 inside = area_.nearest(place);
    if (!area_.ground) return inside;
    const double foot = area_.ground_at(inside.x());
    inside.y() = std::clamp(inside.y(), foot, foot + limit_);
    return inside;
}

int Food::column(double x) const {
    return cell_at(x - area_.left(), columns_);
}

int Food::row(double y) const {
    return cell_at(y - area_.bottom(), rows_);
}

std::vector<std::uint32_t>& Food::cell_of(const Pellet& pellet) {
    const auto index = static_cast<std::size_t>(row(pellet.y)) * static_cast<std::size_t>(columns_);
    return cells_[index + static_cast<std::size_t>(column(pellet.x))];
}

void Food::add(const Vec3& place, Energy energy) {
    if (energy <= 0) return;
    const Vec3 inside = resting(place);
    const Pellet pellet{inside.x(), inside.y(), energy};
    cell_of(pellet).push_back(static_cast<std::uint32_t>(pellets_.size()));
    pellets_.push_back(pellet);
    energy_ += energy;
}

// Calls visit(index, place) for each pellet in the cells that the bounds touch, and for each image
// of it.
template <class Visit>
void Food::visit(const Bounds& bounds, Visit visit) {
    area_.torus().visit_images(area_.bounds(), bounds, [&](const Vec3& shift) {
        const Bounds there = moved(bounds, -shift);
        for (int r = row(there.low.y()); r <= row(there.high.y()); ++r) {
            for (int c = column(there.low.x()); c <= column(there.high.x()); ++c) {
                const auto cell = static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                                  static_cast<std::size_t>(c);
                for (const std::uint32_t index : cells_[cell])
                    visit(index, pellets_[index].place() + shift);
            }
        }
    });
}

void Food::add_near(const Vec3& place, Energy energy, double distance) {
    const Vec3 inside = resting(place);
    const Vec3 margin(distance, distance, 0.0);
    auto nearest = static_cast<std::uint32_t>(pellets_.size());
    visit({inside - margin, inside + margin}, [&](std::uint32_t index, const Vec3& there) {
        if ((there - inside).norm() <= distance) nearest = std::min(nearest, index);
    });
    if (nearest == pellets_.size()) {
        add(inside, energy);
        return;
    }
    pellets_[nearest].energy += energy;
    energy_ += energy;
}

void Food::remove(std::uint32_t index) {
    const auto last = static_cast<std::uint32_t>(pellets_.size() - 1);
    energy_ -= pellets_[index].energy;
    std::erase(cell_of(pellets_[index]), index);
    if (index != last) {
        std::vector<std::uint32_t>& cell = cell_of(pellets_[last]);
        *std::find(cell.begin(), cell.end(), last) = index;
        pellets_[index] = pellets_[last];
    }
    pellets_.pop_back();
}

std::span<const Pellet> Food::take(const Rectangle& rectangle, double distance) {
    taken_.clear();
    if (pellets_.empty()) return taken_;
    found_.clear();
    const Vec3 margin(distance, distance, 0.0);
    const Bounds bounds = bounds_of(rectangle);
    visit({bounds.low - margin, bounds.high + margin}, [&](std::uint32_t index, const Vec3& there) {
        if (distance_to(rectangle, there) <= distance) found_.push_back(index);
    });
    std::sort(found_.begin(), found_.end());
    found_.erase(std::unique(found_.begin(), found_.end()), found_.end());
    for (const std::uint32_t index : found_)
        taken_.push_back(pellets_[index]);
    for (auto index = found_.rbegin(); index != found_.rend(); ++index)
        remove(*index);
    return taken_;
}

Energy Food::rot(double share) {
    const Energy before = energy_;
    for (std::size_t i = pellets_.size(); i-- > 0;) {
        Pellet& pellet = pellets_[i];
        const Energy lost = std::max<Energy>(1, share_of(pellet.energy, share));
        if (pellet.energy - lost < kNoPellet) {
            remove(static_cast<std::uint32_t>(i));
            continue;
        }
        pellet.energy -= lost;
        energy_ -= lost;
    }
    return before - energy_;
}

Energy Food::take_at_least(Energy energy) {
    const Energy before = energy_;
    while (before - energy_ < energy && !pellets_.empty())
        remove(static_cast<std::uint32_t>(pellets_.size() - 1));
    return before - energy_;
}

void Food::replace(std::span<const Pellet> pellets) {
    const std::vector<Pellet> kept(pellets.begin(), pellets.end());
    pellets_.clear();
    for (std::vector<std::uint32_t>& cell : cells_)
        cell.clear();
    energy_ = 0;
    for (const Pellet& pellet : kept)
        add(pellet.place(), pellet.energy);
}

}  // namespace cambrian
