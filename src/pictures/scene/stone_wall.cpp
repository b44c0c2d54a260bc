#include "pictures/scene/stone_wall.h"

#include "pictures/scene/character.h"
#include "pictures/scene/lit_color.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr int kCourses = 7;
constexpr double kJoint = 0.008;       // m, between two stones
constexpr double kCapHeight = 0.09;    // m
constexpr double kCapOverhang = 0.04;  // m
const Color kShadowed = color_of(0x2B2A2E);
const Color kStone = color_of(0x9A948A);
const Color kMoss = color_of(0x7C8A58);

// One stone, with a lighter upper edge.
void add_stone(SceneFrame& frame, const Vec2& center, const Vec2& half, std::uint64_t number) {
    const auto tone = static_cast<float>(0.55 * chance(number, 90));
    const auto moss = static_cast<float>(0.35 * chance(number, 91));
    const Color stone = mix(mix(kStone, kShadowed, 0.6F * tone), kMoss, moss);
    Shape shape;
    shape.center = center;
    shape.half_extents = half;
    shape.radius = 0.45 * half.minCoeff();
    shape.fill = lit(stone, frame.light);
    frame.shapes.push_back(shape);
    shape.center.y() += 0.45 * half.y();
    shape.half_extents = {half.x() - 0.5 * shape.radius, 0.3 * half.y()};
    shape.radius = 0.3 * half.y();
    shape.fill = with_alpha(lit(mix(stone, color_of(0xFFFFFF), 0.4F), frame.light), 0.4F);
    frame.shapes.push_back(shape);
}

}  // namespace

void add_stone_wall(SceneFrame& frame, const FixedBox& wall) {
    const double top = wall.high.y() - kCapHeight;
    const Vec2 middle(wall.center.x(), 0.5 * (wall.low.y() + top));
    frame.add_box(middle, {wall.half_length - kJoint, 0.5 * (top - wall.low.y())},
                  lit(kShadowed, frame.light));
    const double course = (top - wall.low.y()) / kCourses;
    for (int row = 0; row < kCourses; ++row) {
        const auto number = static_cast<std::uint64_t>(row);
        const double seam =
            wall.low.x() + 2.0 * wall.half_length * (0.3 + 0.4 * chance(number, 92));
        const double y = wall.low.y() + (row + 0.5) * course;
        const double ends[] = {wall.low.x(), seam, wall.high.x()};
        for (int k = 0; k < 2; ++k) {
            const double half = 0.5 * (ends[k + 1] - ends[k] - kJoint);
            add_stone(frame, {0.5 * (ends[k] + ends[k + 1]), y}, {half, 0.5 * (course - kJoint)},
                      2 * number + static_cast<std::uint64_t>(k));
        }
    }
    add_stone(frame, {wall.center.x(), top + 0.5 * kCapHeight},
              {wall.half_length + kCapOverhang, 0.5 * kCapHeight}, 2 * kCourses);
}

}  // namespace cambrian
