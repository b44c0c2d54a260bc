#include "studio/panels/viewport/pen_handles.h"

#include "sketch/outline.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

// Lengths on the screen, in units of 1/96 inch.
constexpr double kHandleReach = 10.0;
constexpr double kOutlineReach = 9.0;
constexpr double kSideOut = 12.0;  // of the handles of sides, outside of them
constexpr double kKnobOut = 28.0;  // of the knob from which a new part grows, beyond the end
constexpr double kNearPart = 40.0;
constexpr double kRimShare = 0.3;  // of a thin part's width that belongs to its outline

OutlinePlace outline_of(const BodySketch& sketch, std::size_t part, const Vec2& point) {
    return nearest_on_outline(sketch.body.parts[part],
                              into_part(sketch.body.plan.parts[part], point));
}

PenAim growing_from(const BodySketch& sketch, std::size_t part, const OutlinePlace& place) {
    const Vec2 at = in_world(sketch.body.plan.parts[part], place.point);
    return {PenGrip::kGrow, part, at, at};
}

}  // namespace

std::vector<PenAim> pen_handles(const BodySketch& sketch, std::size_t part, double unit) {
    const PlannedPart& planned = sketch.body.plan.parts[part];
    const double end = planned.half_extents.x();
    const double side = planned.half_extents.y() + kSideOut * unit;
    const auto at = [&](PenGrip grip, double x, double y) {
        return PenAim{grip, part, in_world(planned, {x, y})};
    };
    const auto knob = [&](double sign) {
        PenAim aim = at(PenGrip::kGrow, sign * (end + kKnobOut * unit), 0.0);
        aim.from = in_world(planned, {sign * end, 0.0});
        return aim;
    };
    std::vector<PenAim> handles;
    if (part > 0) handles.push_back(at(PenGrip::kJoint, -end, 0.0));
    handles.push_back(at(PenGrip::kEnd, end, 0.0));
    if (part == 0) handles.push_back(at(PenGrip::kBack, -end, 0.0));
    for (const double sign : {1.0, -1.0}) {
        handles.push_back(at(PenGrip::kSide, 0.0, sign * side));
        handles.back().from = in_world(planned, {0.0, sign * planned.half_extents.y()});
    }
    handles.push_back(knob(1.0));
    if (part == 0) handles.push_back(knob(-1.0));
    return handles;
}

std::optional<std::size_t> part_under(const BodySketch& sketch, const Vec2& point) {
    for (std::size_t part = sketch.body.parts.size(); part-- > 0;) {
        const PlannedPart& planned = sketch.body.plan.parts[part];
        const Vec2 inside = into_part(planned, point);
        if (std::fabs(inside.x()) <= planned.half_extents.x() &&
            std::fabs(inside.y()) <= planned.half_extents.y())
            return part;
    }
    return {};
}

bool is_near_part(const BodySketch& sketch, std::size_t part, const Vec2& point, double unit) {
    const PlannedPart& planned = sketch.body.plan.parts[part];
    const Vec2 inside = into_part(planned, point);
    const double margin = kNearPart * unit;
    return std::fabs(inside.x()) <= planned.half_extents.x() + margin &&
           std::fabs(inside.y()) <= planned.half_extents.y() + margin;
}

PenAim pen_aim(const BodySketch& sketch, std::optional<std::size_t> lit, const Vec2& point,
               double unit) {
    if (lit) {
        PenAim nearest;
        double distance = kHandleReach * unit;
        for (const PenAim& handle : pen_handles(sketch, *lit, unit)) {
            const double away = (handle.place - point).norm();
            if (away > distance) continue;
            distance = away;
            nearest = handle;
        }
        if (nearest.grip != PenGrip::kPaper) return nearest;
    }
    if (const auto under = part_under(sketch, point)) {
        const OutlinePlace rim = outline_of(sketch, *under, point);
        const double width = sketch.body.parts[*under].width;
        if (rim.distance <= std::min(kOutlineReach * unit, kRimShare * width))
            return growing_from(sketch, *under, rim);
        return {*under > 0 ? PenGrip::kJoint : PenGrip::kPaper, *under, point};
    }
    PenAim aim;
    aim.place = point;
    double distance = kOutlineReach * unit;
    for (std::size_t part = 0; part < sketch.body.parts.size(); ++part) {
        const OutlinePlace rim = outline_of(sketch, part, point);
        if (rim.distance > distance) continue;
        distance = rim.distance;
        aim = growing_from(sketch, part, rim);
    }
    return aim;
}

}  // namespace cambrian
