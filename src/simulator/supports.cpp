#include "simulator/supports.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cambrian {

const std::array<Vec3, kHeadings>& headings() {
    static const std::array<Vec3, kHeadings> all = [] {
        constexpr double a = 0.92387953251128674;  // cos 22.5 degrees
        constexpr double b = 0.70710678118654752;
        constexpr double c = 0.38268343236508977;
        constexpr std::array<double, 5> cosines = {1.0, a, b, c, 0.0};
        std::array<Vec3, kHeadings> directions;
        for (std::size_t k = 0; k < kHeadings; ++k) {
            const std::size_t within = k % 4;
            const double along = cosines[within];
            const double across = cosines[4 - within];
            switch (k / 4) {
                case 0:
                    directions[k] = {along, 0.0, across};
                    break;
                case 1:
                    directions[k] = {-across, 0.0, along};
                    break;
                case 2:
                    directions[k] = {-along, 0.0, -across};
                    break;
                default:
                    directions[k] = {across, 0.0, -along};
            }
        }
        return directions;
    }();
    return all;
}

Supports supports_of(const BodyView& body) {
    Supports supports;
    supports.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t part = 0; part < body.part_count(); ++part) {
        const Pose pose = body.part_pose(part);
        const Vec3 half = body.part_half_extents(part);
        const std::array<Vec3, 3> reach = {pose.orientation * Vec3(half.x(), 0.0, 0.0),
                                           pose.orientation * Vec3(0.0, half.y(), 0.0),
                                           pose.orientation * Vec3(0.0, 0.0, half.z())};
        for (std::size_t k = 0; k < kHeadings; ++k) {
            const Vec3& heading = headings()[k];
            double support = heading.dot(pose.position);
            for (const Vec3& side : reach)
                support += std::fabs(heading.dot(side));
            supports[k] = std::max(supports[k], support);
        }
    }
    return supports;
}

}  // namespace cambrian
