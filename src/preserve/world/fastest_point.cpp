#include "preserve/world/fastest_point.h"

#include <algorithm>
#include <cmath>

namespace cambrian {
namespace {

constexpr double kFastestPoint = 200.0;  // m/s

}  // namespace

double fastest_point(const BodyView& body) {
    double fastest = 0.0;
    for (std::size_t i = 0; i < body.part_count(); ++i) {
        const Twist twist = body.part_twist(i);
        const double spin = std::fabs(twist.angular.z()) + std::fabs(body.stretch_rate(i));
        const double speed = twist.linear.norm() + spin * body.part_half_extents(i).norm();
        fastest = std::max(fastest, speed);
    }
    return std::min(kFastestPoint, fastest);
}

}  // namespace cambrian
