#include "pictures/motion/scuffs.h"

#include "math/elementary.h"
#include "simulator/settings/trial_settings.h"

#include <algorithm>
#include <optional>

namespace cambrian {
namespace {

constexpr double kSlip = 0.25;   // m/s; slower feet raise no dust
constexpr double kSwift = 0.55;  // m/s; slower tips leave no wake

Vec2 point_of(const BodyMoment& body, std::size_t part, const Vec2& at) {
    const double growth = exponential(body.stretches[part]);
    return transform(body.poses[part], {growth * at.x(), at.y() / growth, 0.0}).head<2>();
}

// Returns the lowest corner of a part, in its frame at rest.
Vec2 lowest_corner(const PlannedPart& part, const BodyMoment& body, std::size_t index) {
    Vec2 lowest = Vec2::Zero();
    double least = 1e9;
    for (const double x : {-part.half_extents.x(), part.half_extents.x()}) {
        for (const double y : {-part.half_extents.y(), part.half_extents.y()}) {
            const double height = point_of(body, index, {x, y}).y();
            if (height < least) lowest = {x, y};
            least = std::min(least, height);
        }
    }
    return lowest;
}

// Returns the place of a part, in its frame at rest, that may stir up the world in this tick.
std::optional<Vec2> stirring_place(const PlannedPart& part, std::size_t index, std::uint64_t tick,
                                   const BodyMoment& body, bool walks) {
    if (walks) {
        if (body.touched[index] == 0) return std::nullopt;
        return lowest_corner(part, body, index);
    }
    if (part.parent < 0 || tick % 2 != 0) return std::nullopt;
    return Vec2(part.half_extents.x(), 0.0);
}

}  // namespace

void add_scuffs(std::vector<Scuff>& scuffs, const BodyPlan& plan, std::uint64_t tick,
                const BodyMoment& before, const BodyMoment& after, bool walks) {
    for (std::size_t i = 0; i < plan.parts.size(); ++i) {
        const auto at = stirring_place(plan.parts[i], i, tick, after, walks);
        if (!at) continue;
        const Vec2 place = point_of(after, i, *at);
        const Vec2 velocity = (place - point_of(before, i, *at)) / kBrainTick;
        if (velocity.norm() < (walks ? kSlip : kSwift)) continue;
        scuffs.push_back({static_cast<double>(tick) * kBrainTick, place, velocity, tick * 64 + i});
    }
}

std::span<const Scuff> scuffs_seen(std::span<const Scuff> scuffs, double time) {
    const auto earlier = [](const Scuff& scuff, double limit) { return scuff.time <= limit; };
    const auto first = std::lower_bound(scuffs.begin(), scuffs.end(), time - kScuffLife, earlier);
    const auto last = std::lower_bound(first, scuffs.end(), time, earlier);
    return {first, last};
}

}  // namespace cambrian
