#include "simulator/length_meter.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cambrian {
namespace {

// Returns a part's half diagonals; its corners are these and their opposites around the centre.
std::array<Vec2, 2> diagonals_of(const BodyView& body, std::size_t part) {
    const Vec3 half = body.part_half_extents(part);
    const Vec3 axis = body.part_axis(part);
    const Vec2 along(half.x() * axis.x(), half.x() * axis.y());
    const Vec2 across(-half.y() * axis.y(), half.y() * axis.x());
    return {along + across, along - across};
}

// Returns the greatest squared distance of a corner of one part and a corner of another: of the
// vectors `between` + corners and `between` - corners, the longer one has
// |between|^2 + |corners|^2 + 2 |between . corners|.
double greatest_square(const BodyView& body, std::size_t one, std::size_t other,
                       const Vec2& between) {
    double greatest = 0.0;
    for (const Vec2& a : diagonals_of(body, one)) {
        for (const Vec2& b : diagonals_of(body, other)) {
            for (const Vec2& corners : {Vec2(a + b), Vec2(a - b)}) {
                const double along = std::fabs(between.dot(corners));
                greatest = std::max(greatest, corners.squaredNorm() + 2.0 * along);
            }
        }
    }
    return between.squaredNorm() + greatest;
}

// The same of a box in space: of its eight corners, four and their opposites.
std::array<Vec3, 4> space_diagonals_of(const BodyView& body, std::size_t part) {
    const Vec3 half = body.part_half_extents(part);
    const Rotation turn = body.part_pose(part).orientation;
    const Vec3 along = turn * Vec3(half.x(), 0.0, 0.0);
    const Vec3 across = turn * Vec3(0.0, half.y(), 0.0);
    const Vec3 deep = turn * Vec3(0.0, 0.0, half.z());
    return {along + across + deep, along + across - deep, along - across + deep,
            along - across - deep};
}

double greatest_square_in_space(const BodyView& body, std::size_t one, std::size_t other,
                                const Vec3& between) {
    double greatest = 0.0;
    for (const Vec3& a : space_diagonals_of(body, one)) {
        for (const Vec3& b : space_diagonals_of(body, other)) {
            for (const Vec3& corners : {Vec3(a + b), Vec3(a - b)}) {
                const double along = std::fabs(between.dot(corners));
                greatest = std::max(greatest, corners.squaredNorm() + 2.0 * along);
            }
        }
    }
    return between.squaredNorm() + greatest;
}

}  // namespace

// Pairs whose circles cannot be farther apart than the length so far are skipped.
double LengthMeter::longest(const BodyView& body, double so_far) {
    const bool is_spatial = !parts_.empty() && body.part_half_extents(0).z() > 0.0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        const Disc disc{body.part_center(i), body.part_half_extents(i).norm()};
        parts_[i] = disc;
        so_far = std::max(so_far, 2.0 * disc.radius);
        for (std::size_t j = 0; j < i; ++j) {
            const double room = so_far - disc.radius - parts_[j].radius;
            const Vec3 way = disc.center - parts_[j].center;
            const Vec2 between = way.head<2>();
            if (is_spatial) {
                if (room >= 0.0 && way.squaredNorm() <= room * room) continue;
                so_far = std::max(so_far, std::sqrt(greatest_square_in_space(body, i, j, way)));
                continue;
            }
            if (room >= 0.0 && between.squaredNorm() <= room * room) continue;
            so_far = std::max(so_far, std::sqrt(greatest_square(body, i, j, between)));
        }
    }
    return so_far;
}

}  // namespace cambrian
